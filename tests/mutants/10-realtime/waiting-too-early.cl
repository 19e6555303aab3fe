// mutant: a node just before the farthest hit is left out
// task: next_tile_waiting
// caught by: waiting-end
// says: without an epsilon
    while (todo->n > 0) {
        const TodoEntry next = todo_pop(todo);
        if (next.t_min <= farthest - 1e-3f) {
            *at = next;
            return 1;
        }
    }
    return 0;
