// mutant: the last place of the stack stays empty
// task: next_child
// caught by: child-both
// says: nothing put on the stack
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
        if (todo->n + 1 < TODO_SIZE) {
            todo_push(todo, far_child, t_split, t_max);
        }
        return (TodoEntry){near_child, t_min, t_split};
    }
