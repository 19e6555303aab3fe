// mutant: looks at split_axis itself: no step is counted
// task: tile_leaf
// caught by: leaf-steps
// says: no step is counted
    (void)work;
    while (nodes[id].split_axis < 2) {
        const TileNode node = nodes[id];
        id = node.first + ((node.split_axis == 1 ? y : x) >= node.split_pos);
    }
