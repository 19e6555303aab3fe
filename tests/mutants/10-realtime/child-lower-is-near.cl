// mutant: the lower child is always near
// task: next_tile_child
// caught by: child-one
// says: on the eye.s side
    const uint near_child = node.first + 0;
    const uint far_child = node.first + 1;
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min) {
        return (TodoEntry){far_child, at.t_min, at.t_max};
    }
    todo_push(todo, far_child, fmax(at.t_min, t_split.low), at.t_max);
    return (TodoEntry){near_child, at.t_min, fmin(at.t_max, t_split.high)};
