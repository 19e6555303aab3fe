// mutant: the far child alone begins at the least t_split
// task: next_tile_child
// caught by: child-one
// says: stays as it is
    const int is_below = eye <= node.split_pos;
    const uint near_child = is_below ? node.first : node.first + 1;
    const uint far_child = is_below ? node.first + 1 : node.first;
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min) {
        return (TodoEntry){far_child, t_split.low, at.t_max};
    }
    todo_push(todo, far_child, fmax(at.t_min, t_split.low), at.t_max);
    return (TodoEntry){near_child, at.t_min, fmin(at.t_max, t_split.high)};
