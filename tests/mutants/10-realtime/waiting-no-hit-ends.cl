// mutant: the search ends while a ray has no hit
// task: next_tile_waiting
// caught by: waiting-end
// says: no hit yet
    while (todo->n > 0 && farthest < INFINITY) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
