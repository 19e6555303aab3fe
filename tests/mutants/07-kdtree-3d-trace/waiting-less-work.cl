// mutant: it ends at any hit: too little work
// task: next_waiting
// caught by: trace-work
// says: ends too soon
    if (hit.t < INFINITY || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
