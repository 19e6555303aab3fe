// mutant: the node waits still
// task: next_tile_waiting
// caught by: waiting-next
// says: waits still
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            todo->n++;
            return 1;
        }
    }
    return 0;
