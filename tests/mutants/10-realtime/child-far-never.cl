// mutant: the far child is never visited, as if one ray were traced that stays on its side
// task: next_tile_child
// caught by: tile-hits
// says: rays are wrong
    (void)t_split, (void)todo;
    return (TodoEntry){node.first + (eye <= node.split_pos ? 0 : 1), at.t_min, at.t_max};
