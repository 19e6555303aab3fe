// mutant: at most ten nodes are taken
// task: next_tile_waiting
// caught by: waiting-end
// says: however many
    for (int i = 0; i < 10 && todo->n > 0; i++) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
