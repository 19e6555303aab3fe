// mutant: the first child every time
// task: tile_leaf
// caught by: leaf-tile
// says: lower child were taken every time
    (void)x, (void)y;
    while (is_inner(nodes[id], work)) {
        id = nodes[id].first + (0);
    }
