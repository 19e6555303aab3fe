// mutant: nodes that begin less than 1e-4 behind the farthest hit are visited
// task: next_tile_waiting
// caught by: waiting-end
// says: without an epsilon
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest + 1e-4f) {
            return 1;
        }
    }
    return 0;
