// mutant: the last node is never taken
// task: next_tile_waiting
// caught by: waiting-end
// says: one node was still waiting
    while (todo->n > 1) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
