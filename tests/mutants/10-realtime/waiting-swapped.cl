// mutant: 1 for the end
// task: next_tile_waiting
// caught by: waiting-end
// says: swapped
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 0;
        }
    }
    return 1;
