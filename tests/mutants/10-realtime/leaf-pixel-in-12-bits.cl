// mutant: the pixel is cut to 12 bits
// task: tile_leaf
// caught by: leaf-tile
// says: the pixel was cut
    while (is_inner(nodes[id], work)) {
        const int at = (nodes[id].split_axis == 0 ? x : y) & 0xfff;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
