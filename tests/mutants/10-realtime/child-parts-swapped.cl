// mutant: each child has the part of the other one
// task: next_tile_child
// caught by: child-both
// says: parts are swapped
    const uint near_child = node.first + (eye <= node.split_pos ? 0 : 1);
    const uint far_child = node.first + (eye <= node.split_pos ? 1 : 0);
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min) {
        return (TodoEntry){far_child, at.t_min, at.t_max};
    }
    todo_push(todo, far_child, at.t_min, fmin(at.t_max, t_split.high));
    return (TodoEntry){near_child, fmax(at.t_min, t_split.low), at.t_max};
