// mutant: the popped entry is thrown away
// task: next_waiting
// caught by: waiting-next
// says: did not become
    if (todo->n > 0 && !(hit.t < at->t_max)) {
        const TodoEntry next = todo_pop(todo);
        (void)next;
        return 1;
    }
    return 0;
