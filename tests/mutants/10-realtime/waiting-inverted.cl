// mutant: nodes behind the hits are taken
// task: next_tile_waiting
// caught by: waiting-end
// says: inverted
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min > farthest) {
            return 1;
        }
    }
    return 0;
