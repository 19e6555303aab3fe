// mutant: the node without its t_max
// task: next_tile_waiting
// caught by: waiting-next
// says: t_max were not taken
    while (todo->n > 0) {
        const TodoEntry next = todo_pop(todo);
        if (next.t_min <= farthest) {
            at->node = next.node;
            at->t_min = next.t_min;
            return 1;
        }
    }
    return 0;
