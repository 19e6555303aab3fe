// mutant: a node must end before the farthest hit
// task: next_tile_waiting
// caught by: waiting-next
// says: its t_min counts
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_max <= farthest) {
            return 1;
        }
    }
    return 0;
