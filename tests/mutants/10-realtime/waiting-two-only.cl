// mutant: at most one node is left out
// task: next_tile_waiting
// caught by: waiting-end
// says: more than one node
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    if (at->t_min > farthest) {
        if (todo->n == 0) {
            return 0;
        }
        *at = todo_pop(todo);
    }
    return 1;
