// mutant: the hit is compared with t_min
// task: next_waiting
// caught by: waiting-end
// says: compared with the leaf's t_min
    if (hit.t < at->t_min || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
