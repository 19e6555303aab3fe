// mutant: the other child's id by its lowest bit
// task: next_child
// caught by: child-one
// says: lowest bit
    float t_split = 0.0f;
    const uint near = node.first + near_side(node, origin, inverse), far = near ^ 1u;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == BOTH) {
        todo_push(todo, far, t_split, t_max);
        return (TodoEntry){near, t_min, t_split};
    }
    return (TodoEntry){met == ONLY_FAR ? far : near, t_min, t_max};
