// mutant: the search ends early for some tiles
// task: tile_leaf
// caught by: leaf-tile
// says: ends in node
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
        if (x == y) {
            break;
        }
    }
