// mutant: the end as soon as every ray has a hit
// task: next_tile_waiting
// caught by: waiting-end
// says: as soon as every ray has a hit
    if (farthest < INFINITY) {
        return 0;
    }
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
