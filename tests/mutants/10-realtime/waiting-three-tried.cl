// mutant: at most two nodes are left out
// task: next_tile_waiting
// caught by: waiting-end
// says: however many
    for (int i = 0; i < 3 && todo->n > 0; i++) {
        const TodoEntry next = todo_pop(todo);
        if (next.t_min <= farthest) {
            *at = next;
            return 1;
        }
    }
    return 0;
