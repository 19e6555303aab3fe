// mutant: the hits do not matter
// task: next_tile_waiting
// caught by: waiting-end
// says: they are left out
    (void)farthest;
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
