// mutant: ten levels at most
// task: tile_leaf
// caught by: leaf-tile
// says: ended after some steps
    for (int level = 0; level < 10 && is_inner(nodes[id], work); level++) {
        const TileNode node = nodes[id];
        const int at = node.split_axis == 0 ? x : y;
        id = node.first + (at >= node.split_pos ? 1 : 0);
    }
