// mutant: a hit beyond t_max by a hundred-thousandth of it ends the search
// task: next_waiting
// caught by: waiting-end
// says: epsilon
    if (hit.t <= at->t_max * 1.00001f || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
