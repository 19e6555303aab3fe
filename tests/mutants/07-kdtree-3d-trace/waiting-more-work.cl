// mutant: it goes on behind a hit where nodes wait: right, but too much work
// task: next_waiting
// caught by: trace-work
// says: more than they need
    (void)hit;
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
