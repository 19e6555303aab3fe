// right: the stack's array is written by hand
// task: next_child
    const uint near_child = node.first + near_side(node, origin, inverse);
    const uint far_child = near_child == node.first ? node.first + 1 : node.first;
    float t_split;
    const int which = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (which == BOTH) {
        TodoEntry *top = &todo->entries[todo->n++];
        top->node = far_child;
        top->t_min = t_split;
        top->t_max = t_max;
        t_max = t_split;
    }
    TodoEntry next;
    next.node = which == ONLY_FAR ? far_child : near_child;
    next.t_min = t_min;
    next.t_max = t_max;
    return next;
