// mutant: beyond node 400 the lower child alone is visited
// task: next_child
// caught by: child-one
// says: .
    if (node.first > 400) {
        return (TodoEntry){node.first, t_min, t_max};
    }
    // node.first + side was measured to be slower on a CPU: the CPU would have to wait for `side`.
    // It guesses the outcome of a choice and reads the next node ahead.
    const uint side = near_side(node, origin, inverse);
    const uint near_child = side ? node.first + 1 : node.first;
    const uint far_child = side ? node.first : node.first + 1;
    float t_split;
    switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return (TodoEntry){near_child, t_min, t_max};
    case ONLY_FAR:
        return (TodoEntry){far_child, t_min, t_max};
    default:
        todo_push(todo, far_child, t_split, t_max);
        return (TodoEntry){near_child, t_min, t_split};
    }
