// mutant: a hit before t_min does not end the search
// task: next_waiting
// caught by: waiting-end
// says: before t_min
    if ((hit.t >= at->t_min && hit.t < at->t_max) || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
