// mutant: whatever waits is visited
// task: next_tile_waiting
// caught by: tile-work
// says: more than they need
    (void)farthest;
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
