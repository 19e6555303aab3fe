// mutant: compares the number of the tile
// task: tile_leaf
// caught by: leaf-tile
// says: tile.s number
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x / 16 : y / 16;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
