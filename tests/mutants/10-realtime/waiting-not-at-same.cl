// mutant: a node at the very distance is left out
// task: next_tile_waiting
// caught by: waiting-next
// says: exactly at the farthest
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min < farthest) {
            return 1;
        }
    }
    return 0;
