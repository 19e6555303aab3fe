// right: one way for both cases: the far child alone is a swap
// task: next_child
    TodoEntry next = {node.first + near_side(node, origin, inverse), t_min, t_max};
    const uint other = 2 * node.first + 1 - next.node;
    float t_split = t_max;
    const int which = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (which == ONLY_FAR) {
        next.node = other;
    } else if (which == BOTH) {
        todo_push(todo, other, t_split, t_max);
        next.t_max = t_split;
    }
    return next;
