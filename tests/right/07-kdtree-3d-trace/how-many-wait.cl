// right: it says how many nodes waited, and takes the top by hand
// task: next_waiting
    const uint n_waiting = hit.t < at->t_max ? 0 : todo->n;
    if (n_waiting > 0) {
        todo->n = n_waiting - 1;
        *at = todo->entries[n_waiting - 1];
    }
    return (int)n_waiting;
