// right: the top one of those that wait begins where the leaf's part of the ray ends
// task: next_waiting
    if (todo->n == 0) {
        return 0;
    }
    const TodoEntry top = todo->entries[todo->n - 1];
    if (hit.t < top.t_min) {
        return 0;
    }
    todo->n--;
    *at = top;
    return 1;
