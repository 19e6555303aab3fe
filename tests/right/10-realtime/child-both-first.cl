// right: both first
// task: next_tile_child
    const int side = eye > node.split_pos;
    const TodoEntry near_child = {node.first + side, at.t_min, at.t_max};
    const TodoEntry far_child = {node.first + !side, at.t_min, at.t_max};
    if (t_split.low <= at.t_max && t_split.high >= at.t_min) {
        todo_push(todo, far_child.node, t_split.low < at.t_min ? at.t_min : t_split.low, at.t_max);
        return (TodoEntry){near_child.node, at.t_min,
                           t_split.high > at.t_max ? at.t_max : t_split.high};
    }
    return t_split.low > at.t_max ? near_child : far_child;
