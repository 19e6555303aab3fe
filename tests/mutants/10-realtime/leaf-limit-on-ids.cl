// mutant: no id beyond 1023
// task: tile_leaf
// caught by: leaf-tile
// says: large id
    while (id < 1024 && is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
