// mutant: the hit is compared with the next node's t_max
// task: next_waiting
// caught by: waiting-end
// says: node from the stack
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    if (hit.t < at->t_max) {
        return 0;
    }
    return 1;
