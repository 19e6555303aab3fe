// mutant: the part is cut where only the near child is met
// task: next_child
// caught by: child-one
// says: only the near child is met the part
    float t_split = 0.0f;
    const uint side = near_side(node, origin, inverse), near = node.first + side,
               far = node.first + 1 - side;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == ONLY_FAR) {
        return (TodoEntry){far, t_min, t_max};
    }
    if (met == BOTH) {
        todo_push(todo, far, t_split, t_max);
    }
    return (TodoEntry){near, t_min, fmin(t_split, t_max)};
