// mutant: beyond node 1200 the lower child alone is visited
// task: next_tile_child
// caught by: child-one
// says: .
    if (node.first > 1200) {
        return (TodoEntry){node.first, at.t_min, at.t_max};
    }
    const uint near_child = node.first + (eye <= node.split_pos ? 0 : 1);
    const uint far_child = node.first + (eye <= node.split_pos ? 1 : 0);
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min) {
        return (TodoEntry){far_child, at.t_min, at.t_max};
    }
    todo_push(todo, far_child, fmax(at.t_min, t_split.low), at.t_max);
    return (TodoEntry){near_child, at.t_min, fmin(at.t_max, t_split.high)};
