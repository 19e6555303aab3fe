// right: the case in which it goes on comes first
// task: next_waiting
    const int goes_on = hit.t >= at->t_max && todo->n > 0;
    if (goes_on) {
        const TodoEntry next = todo_pop(todo);
        at->node = next.node;
        at->t_min = next.t_min;
        at->t_max = next.t_max;
    }
    return goes_on;
