// mutant: the search ends where there is no hit
// task: next_waiting
// caught by: waiting-end
// says: inverted
    if (hit.t >= at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
