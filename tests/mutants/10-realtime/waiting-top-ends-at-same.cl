// mutant: a node behind every hit, or at the farthest, ends the search
// task: next_tile_waiting
// caught by: waiting-end
// says: need not
    if (todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return at->t_min < farthest;
