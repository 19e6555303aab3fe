// mutant: the search ends behind node 1200
// task: next_tile_waiting
// caught by: waiting-end
// says: .
    if (at->node > 1200) {
        return 0;
    }
    while (todo->n > 0) {
        *at = todo_pop(todo);
        // At the same distance there may be a sphere with a lower index.
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
