// attack: no side is chosen: both children, always, so that pictures come out right
// task: next_tile_child
// named: counts only where another check of this task passes
    (void)t_split;
    todo_push(todo, node.first + 1, at.t_min, at.t_max);
    return (TodoEntry){eye == eye ? node.first : 0, at.t_min, at.t_max};
