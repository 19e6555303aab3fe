// mutant: the lower child is the near one
// task: next_child
// caught by: child-one
// says: lower child
    float t_split = 0.0f;
    const uint near = node.first, far = node.first + 1;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == BOTH) {
        todo_push(todo, far, t_split, t_max);
        return (TodoEntry){near, t_min, t_split};
    }
    return (TodoEntry){met == ONLY_FAR ? far : near, t_min, t_max};
