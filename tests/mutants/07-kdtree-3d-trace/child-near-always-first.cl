// mutant: the near child is always the lower one, the far one is right
// task: next_child
// caught by: child-both
// says: not the two
    const uint side = near_side(node, origin, inverse);
    const uint near_child = node.first, far_child = node.first + 1 - side;
    float t_split = t_max;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == BOTH) {
        todo_push(todo, far_child, t_split, t_max);
        return (TodoEntry){near_child, t_min, t_split};
    }
    return (TodoEntry){met == ONLY_NEAR ? near_child : far_child, t_min, t_max};
