// right: a loop that is left in the middle
// task: next_tile_waiting
    for (;;) {
        if (todo->n == 0) {
            return 0;
        }
        const TodoEntry next = todo_pop(todo);
        if (farthest < next.t_min) {
            continue;
        }
        *at = next;
        return 1;
    }
