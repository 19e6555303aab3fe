// mutant: the far child is always the upper one
// task: next_tile_child
// caught by: child-both
// says: not the two
    const uint side = eye > node.split_pos;
    const uint near_child = node.first + side, far_child = node.first + 1;
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min) {
        return (TodoEntry){far_child, at.t_min, at.t_max};
    }
    todo_push(todo, far_child, fmax(at.t_min, t_split.low), at.t_max);
    return (TodoEntry){near_child, at.t_min, fmin(t_split.high, at.t_max)};
