// mutant: a node whose part is a point is left out
// task: next_tile_waiting
// caught by: waiting-next
// says: whose part is a point
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest && at->t_min < at->t_max) {
            return 1;
        }
    }
    return 0;
