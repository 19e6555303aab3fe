// mutant: t_max is not taken from the stack
// task: next_waiting
// caught by: waiting-next
// says: t_max were not taken
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    const TodoEntry next = todo_pop(todo);
    at->node = next.node;
    at->t_min = next.t_min;
    return 1;
