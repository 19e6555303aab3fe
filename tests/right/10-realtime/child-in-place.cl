// right: the part is changed in place
// task: next_tile_child
    uint near_child = node.first, far_child = node.first + 1;
    if (eye > node.split_pos) {
        near_child++;
        far_child--;
    }
    at.node = near_child;
    if (t_split.high < at.t_min) {
        at.node = far_child;
    } else if (!(t_split.low > at.t_max)) {
        todo_push(todo, far_child, max(t_split.low, at.t_min), at.t_max);
        at.t_max = min(t_split.high, at.t_max);
    }
    return at;
