// mutant: a hit at t_max exactly ends the search
// task: next_waiting
// caught by: waiting-end
// says: exactly at t_max
    if (hit.t <= at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
