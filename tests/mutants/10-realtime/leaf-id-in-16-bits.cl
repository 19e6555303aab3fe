// mutant: the id is kept in 16 bits
// task: tile_leaf
// caught by: leaf-tile
// says: cut to 8 or 16 bits
    ushort child = 0;
    while (is_inner(nodes[child], work)) {
        const TileNode node = nodes[child];
        const int at = node.split_axis == 0 ? x : y;
        child = (ushort)(node.first + (at >= node.split_pos ? 1 : 0));
    }
    id = child;
