// right: without todo_pop
// task: next_tile_waiting
    uint n = todo->n;
    while (n > 0 && todo->entries[n - 1].t_min > farthest) {
        n--;
    }
    if (n == 0) {
        todo->n = 0;
        return 0;
    }
    *at = todo->entries[n - 1];
    todo->n = n - 1;
    return 1;
