// mutant: the direction chooses the near child: near_side is not asked
// task: next_child
// caught by: child-one
// says: goes on with node
    const uint side = inverse < 0.0f;
    const uint near_child = node.first + side;
    const uint far_child = node.first + 1 - side;
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
