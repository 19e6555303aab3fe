// mutant: the node that waits longest is taken from the stack first
// task: next_waiting
// caught by: waiting-next
// says: waits longest
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo->entries[0];
    todo->n--;
    for (uint i = 0; i < todo->n; i++) {
        todo->entries[i] = todo->entries[i + 1];
    }
    return 1;
