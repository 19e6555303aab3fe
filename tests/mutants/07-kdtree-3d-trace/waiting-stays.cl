// mutant: the node is looked at on the stack, and not taken off
// task: next_waiting
// caught by: waiting-next
// says: waits still
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo->entries[todo->n - 1];
    return 1;
