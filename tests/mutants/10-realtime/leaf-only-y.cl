// mutant: all planes are taken for planes across y
// task: tile_leaf
// caught by: leaf-tile
// says: across y
    while (is_inner(nodes[id], work)) {
        const int at = y; (void)x;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
