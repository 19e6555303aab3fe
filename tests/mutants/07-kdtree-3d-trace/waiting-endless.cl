// mutant: the node that comes next stays on the stack: the loop does not end
// task: next_waiting
// caught by: trace-edges
// says: time
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo->entries[todo->n - 1];
    return 1;
