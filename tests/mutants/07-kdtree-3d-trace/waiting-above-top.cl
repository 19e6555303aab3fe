// mutant: the place above the top is read
// task: next_waiting
// caught by: waiting-next
// says: none of the entries
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo->entries[todo->n];
    todo->n--;
    return 1;
