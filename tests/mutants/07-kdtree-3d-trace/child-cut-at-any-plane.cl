// mutant: the part is cut where one child is met, too
// task: next_child
// caught by: child-one
// says: stays as it is
    const uint side = near_side(node, origin, inverse);
    float t_split;
    const int which = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (which == ONLY_NEAR) {
        return (TodoEntry){node.first + side, t_min, t_split};
    }
    if (which == ONLY_FAR) {
        return (TodoEntry){node.first + 1 - side, t_split, t_max};
    }
    todo_push(todo, node.first + 1 - side, t_split, t_max);
    return (TodoEntry){node.first + side, t_min, t_split};
