// mutant: goes to the side in the place of the child: 0 or 1
// task: next_child
// caught by: child-one
// says: that is a side and no id
    const uint side = near_side(node, origin, inverse);
    float t_split;
    switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
    case ONLY_NEAR:
        return (TodoEntry){side, t_min, t_max};
    case ONLY_FAR:
        return (TodoEntry){!side, t_min, t_max};
    default:
        todo_push(todo, node.first + !side, t_split, t_max);
        return (TodoEntry){side, t_min, t_split};
    }
