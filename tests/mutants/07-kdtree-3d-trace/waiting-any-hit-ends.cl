// mutant: the search ends at any hit, also beyond t_max
// task: next_waiting
// caught by: waiting-end
// says: any hit
    if (hit.t < INFINITY || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
