// mutant: both children, wherever the plane is
// task: next_tile_child
// caught by: child-one
// says: both children were always
    const uint near_child = node.first + (eye <= node.split_pos ? 0 : 1);
    const uint far_child = node.first + (eye <= node.split_pos ? 1 : 0);
    todo_push(todo, far_child, fmax(at.t_min, t_split.low), at.t_max);
    return (TodoEntry){near_child, at.t_min, fmin(at.t_max, t_split.high)};
