// mutant: lab 07's function, and a hit at the leaf's end ends the search, too
// task: next_tile_waiting
// caught by: waiting-end
// says: lab 07.s rule
    if (todo->n == 0 || farthest <= at->t_max) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
