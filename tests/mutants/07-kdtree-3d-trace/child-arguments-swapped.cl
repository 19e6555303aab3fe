// mutant: t_min and t_max are swapped in the call
// task: next_child
// caught by: child-both
// says: in another order
    const uint side = near_side(node, origin, inverse);
    const uint near_child = node.first + side, far_child = node.first + 1 - side;
    float t_split = t_max;
    const int met = children_on_ray(node, origin, inverse, t_max, t_min, &t_split);
    if (met == BOTH) {
        todo_push(todo, far_child, t_split, t_max);
        return (TodoEntry){near_child, t_min, t_split};
    }
    return (TodoEntry){met == ONLY_NEAR ? near_child : far_child, t_min, t_max};
