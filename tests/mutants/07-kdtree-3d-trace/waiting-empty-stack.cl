// mutant: an empty stack does not end the search: something is taken from it all the same
// task: next_waiting
// caught by: waiting-end
// says: expected the end|crash|time|CL_OUT_OF_RESOURCES
    if (hit.t < at->t_max) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
