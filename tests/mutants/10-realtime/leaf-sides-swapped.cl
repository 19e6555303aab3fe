// mutant: the children are swapped
// task: tile_leaf
// caught by: leaf-tile
// says: sides are swapped
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 1 : 0);
    }
