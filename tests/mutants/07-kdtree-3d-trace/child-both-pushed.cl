// mutant: both wait, and the near one is taken off again
// task: next_child
// caught by: child-both
// says: one place is left|crash.*next_child
    float t_split = 0.0f;
    const uint side = near_side(node, origin, inverse), near = node.first + side,
               far = node.first + 1 - side;
    const int met = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
    if (met == ONLY_NEAR) {
        todo_push(todo, near, t_min, t_max);
    } else if (met == ONLY_FAR) {
        todo_push(todo, far, t_min, t_max);
    } else {
        todo_push(todo, far, t_split, t_max);
        todo_push(todo, near, t_min, t_split);
    }
    return todo_pop(todo);
