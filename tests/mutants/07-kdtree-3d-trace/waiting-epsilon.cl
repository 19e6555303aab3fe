// mutant: a hit a little beyond t_max ends the search, too
// task: next_waiting
// caught by: waiting-end
// says: epsilon
    if (hit.t < at->t_max + 1e-4f || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
