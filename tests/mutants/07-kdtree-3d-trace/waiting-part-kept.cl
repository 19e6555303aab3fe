// mutant: t_min and t_max are not taken from the stack
// task: next_waiting
// caught by: waiting-next
// says: t_min and t_max were not taken
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    at->node = todo_pop(todo).node;
    return 1;
