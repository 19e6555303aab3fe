// mutant: the parts of both children are swapped
// task: next_child
// caught by: child-both
// says: goes on with node
    const uint side = near_side(node, origin, inverse);
    const uint near_child = node.first + side;
    const uint far_child = node.first + 1 - side;
    float t_split;
    switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return (TodoEntry){near_child, t_min, t_max};
    case ONLY_FAR:
        return (TodoEntry){far_child, t_min, t_max};
    default:
        todo_push(todo, far_child, t_min, t_split);
        return (TodoEntry){near_child, t_split, t_max};
    }
