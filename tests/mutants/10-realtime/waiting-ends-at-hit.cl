// mutant: the part ends at the farthest hit, wherever it ended
// task: next_tile_waiting
// caught by: waiting-next
// says: never grows
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            at->t_max = farthest;
            return 1;
        }
    }
    return 0;
