// mutant: the part is cut at the farthest hit
// task: next_tile_waiting
// caught by: waiting-next
// says: its own part
    while (todo->n > 0) {
        const TodoEntry next = todo_pop(todo);
        if (next.t_min <= farthest) {
            *at = next;
            at->t_max = fmin(at->t_max, farthest);
            return 1;
        }
    }
    return 0;
