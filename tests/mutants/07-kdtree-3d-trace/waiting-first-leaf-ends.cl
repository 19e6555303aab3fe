// mutant: the search ends at the first leaf
// task: next_waiting
// caught by: waiting-end
// says: ends the search, expected: it goes on
    if (hit.t < at->t_max || todo->n < 100) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
