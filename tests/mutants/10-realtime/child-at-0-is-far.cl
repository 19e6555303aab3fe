// mutant: a plane that is met at 0 is thought to need the far child alone
// task: next_tile_child
// caught by: child-both
// says: met at 0
    const int is_below = eye <= node.split_pos;
    const uint near_child = is_below ? node.first : node.first + 1;
    const uint far_child = is_below ? node.first + 1 : node.first;
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min || t_split.high == 0.0f) {
        return (TodoEntry){far_child, at.t_min, at.t_max};
    }
    todo_push(todo, far_child, fmax(at.t_min, t_split.low), at.t_max);
    return (TodoEntry){near_child, at.t_min, fmin(at.t_max, t_split.high)};
