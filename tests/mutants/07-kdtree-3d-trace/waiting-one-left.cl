// mutant: the search ends with one node waiting
// task: next_waiting
// caught by: waiting-end
// says: still waiting
    if (hit.t < at->t_max || todo->n <= 1) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
