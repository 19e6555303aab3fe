// right: by the tile's last pixel
// task: tile_leaf
    const int last[2] = {x + CIRCLE_TILE_SIDE - 1, y + CIRCLE_TILE_SIDE - 1};
    for (TileNode node = nodes[0]; is_inner(node, work); node = nodes[id]) {
        id = node.first;
        if (last[node.split_axis] >= node.split_pos) {
            id++;
        }
    }
