// mutant: the near part ends where it begins
// task: next_child
// caught by: child-both
// says: child or part is another
    const uint side = near_side(node, origin, inverse);
    const uint near_child = node.first + side, far_child = node.first + 1 - side;
    float t_split = t_max;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == BOTH) {
        todo_push(todo, far_child, t_split, t_max);
        return (TodoEntry){near_child, t_min, t_min};
    }
    return (TodoEntry){met == ONLY_NEAR ? near_child : far_child, t_min, t_max};
