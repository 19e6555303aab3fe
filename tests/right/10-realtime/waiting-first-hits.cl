// right: no comparison as long as a ray has no hit
// task: next_tile_waiting
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (isinf(farthest) || at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
