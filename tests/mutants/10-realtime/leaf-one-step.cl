// mutant: one step instead of all
// task: tile_leaf
// caught by: leaf-tile
// says: ended after one step
    if (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
