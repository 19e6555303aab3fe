// mutant: the search ends in a leaf that ends beyond 100
// task: next_waiting
// caught by: waiting-end
// says: .
    if (at->t_max > 100.0f) {
        return 0;
    }
    // A hit beyond t_max may be hidden by a sphere that only a later leaf lists. At t_max a later
    // leaf may list a sphere with a lower index that is hit at the same distance.
    if (hit.t < at->t_max || todo->n == 0) {
        return 0;
    }
    *at = todo_pop(todo);
    return 1;
