// mutant: both parts reach beyond the own one of the node
// task: next_tile_child
// caught by: child-both
// says: wider than the node
    const uint near_child = node.first + (eye <= node.split_pos ? 0 : 1);
    const uint far_child = node.first + (eye <= node.split_pos ? 1 : 0);
    if (t_split.low > at.t_max) {
        return (TodoEntry){near_child, at.t_min, at.t_max};
    }
    if (t_split.high < at.t_min) {
        return (TodoEntry){far_child, at.t_min, at.t_max};
    }
    todo_push(todo, far_child, t_split.low, at.t_max);
    return (TodoEntry){near_child, at.t_min, t_split.high};
