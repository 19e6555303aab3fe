// mutant: the node that waits longest first
// task: next_tile_waiting
// caught by: waiting-next
// says: longest
    for (uint i = 0; i < todo->n; i++) {
        if (todo->entries[i].t_min <= farthest) {
            *at = todo->entries[i];
            todo->n -= i + 1;
            return 1;
        }
    }
    return 0;
