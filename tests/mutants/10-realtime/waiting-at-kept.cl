// mutant: the node is not written to *at
// task: next_tile_waiting
// caught by: waiting-next
// says: not handed on
    while (todo->n > 0) {
        const TodoEntry next = todo_pop(todo);
        if (next.t_min <= farthest) {
            return 1;
        }
    }
    return 0;
