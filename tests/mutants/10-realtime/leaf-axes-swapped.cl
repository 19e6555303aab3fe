// mutant: x is compared on axis 1
// task: tile_leaf
// caught by: leaf-tile
// says: axes are swapped
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? y : x;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
