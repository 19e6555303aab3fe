// mutant: the leaf's own begin is compared
// task: next_tile_waiting
// caught by: waiting-end
// says: where the leaf did
    const float begin = at->t_min;
    while (todo->n > 0) {
        const TodoEntry next = todo_pop(todo);
        if (begin <= farthest) {
            *at = next;
            return 1;
        }
    }
    return 0;
