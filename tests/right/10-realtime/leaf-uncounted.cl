// right: looks at split_axis itself
// task: tile_leaf
    (void)work;
    while (nodes[id].split_axis < 2) {
        const TileNode node = nodes[id];
        id = node.first + ((node.split_axis == 1 ? y : x) >= node.split_pos);
    }
