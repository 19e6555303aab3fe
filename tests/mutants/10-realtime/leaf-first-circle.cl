// mutant: returns where the circles begin
// task: tile_leaf
// caught by: leaf-tile
// says: own id
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
    return nodes[id].first;
