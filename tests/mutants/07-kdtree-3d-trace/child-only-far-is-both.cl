// mutant: the near child is visited before the far one where only that is met
// task: next_child
// caught by: child-one
// says: near child were visited also
    const uint side = near_side(node, origin, inverse);
    const uint near_child = node.first + side;
    const uint far_child = node.first + 1 - side;
    float t_split;
    switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return (TodoEntry){near_child, t_min, t_max};
    default:
        todo_push(todo, far_child, t_split, t_max);
        return (TodoEntry){near_child, t_min, t_split};
    }
