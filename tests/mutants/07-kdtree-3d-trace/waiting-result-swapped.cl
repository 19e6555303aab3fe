// mutant: 1 where the search is over, 0 where it goes on
// task: next_waiting
// caught by: waiting-end
// says: swapped
    if (hit.t < at->t_max || todo->n == 0) {
        return 1;
    }
    *at = todo_pop(todo);
    return 0;
