// mutant: t_min is not taken from the stack
// task: next_waiting
// caught by: waiting-next
// says: t_min were not taken
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    const TodoEntry next = todo_pop(todo);
    at->node = next.node;
    at->t_max = next.t_max;
    return 1;
