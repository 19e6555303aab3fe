// mutant: all planes are taken for planes across x
// task: tile_leaf
// caught by: leaf-tile
// says: across x
    while (is_inner(nodes[id], work)) {
        const int at = x; (void)y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
