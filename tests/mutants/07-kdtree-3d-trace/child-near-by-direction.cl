// mutant: the direction decides which child is near
// task: next_child
// caught by: child-one
// says: direction decided
    float t_split = 0.0f;
    const uint side = inverse > 0.0f ? 0 : 1, near = node.first + side, far = node.first + 1 - side;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == BOTH) {
        todo_push(todo, far, t_split, t_max);
        return (TodoEntry){near, t_min, t_split};
    }
    return (TodoEntry){met == ONLY_FAR ? far : near, t_min, t_max};
