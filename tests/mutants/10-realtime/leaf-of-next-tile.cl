// mutant: the first pixel behind the tile is asked
// task: tile_leaf
// caught by: leaf-tile
// says: behind the tile
    while (is_inner(nodes[id], work)) {
        const TileNode node = nodes[id];
        const int at = (node.split_axis == 0 ? x : y) + LANES;
        id = node.first + (at >= node.split_pos ? 1 : 0);
    }
