// mutant: lab 07's function
// task: next_tile_waiting
// caught by: waiting-next
// says: lab 07.s rule
    if (todo->n == 0 || farthest < at->t_max) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
