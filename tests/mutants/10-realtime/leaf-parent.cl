// mutant: ends one node too early
// task: tile_leaf
// caught by: leaf-tile
// says: above the leaf
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        const uint next = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
        if (nodes[next].split_axis == KD_LEAF) {
            return id;
        }
        id = next;
    }
