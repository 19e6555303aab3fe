// mutant: the search ends only when the stack is empty
// task: next_waiting
// caught by: waiting-end
// says: stack is empty
    (void)hit;
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
