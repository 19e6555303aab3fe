// right: what lies behind the farthest hit is cut off
// task: next_tile_waiting
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            at->t_max = fmin(at->t_max, farthest);
            return 1;
        }
    }
    return 0;
