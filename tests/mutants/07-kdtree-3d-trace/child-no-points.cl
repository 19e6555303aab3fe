// mutant: a part that is a point is left out
// task: next_child
// caught by: child-both
// says: is a point
    float t_split = 0.0f;
    const uint side = near_side(node, origin, inverse), near = node.first + side,
               far = node.first + 1 - side;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == BOTH && t_split > t_min && t_split < t_max) {
        todo_push(todo, far, t_split, t_max);
        return (TodoEntry){near, t_min, t_split};
    }
    return (TodoEntry){met == ONLY_FAR || (met == BOTH && t_split <= t_min) ? far : near, t_min,
                       t_max};
