// mutant: a hit inside of the leaf or at its end ends the search
// task: next_tile_waiting
// caught by: waiting-end
// says: lab 07.s rule
    if (farthest <= at->t_max) { return 0; }
    while (todo->n > 0) {
        *at = todo_pop(todo);
        if (at->t_min <= farthest) {
            return 1;
        }
    }
    return 0;
