// mutant: the pixel is cut to 16 bits
// task: tile_leaf
// caught by: leaf-tile
// says: the pixel was cut
    while (is_inner(nodes[id], work)) {
        const int at = (short)(nodes[id].split_axis == 0 ? x : y);
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
