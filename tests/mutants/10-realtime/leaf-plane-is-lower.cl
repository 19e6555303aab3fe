// mutant: a tile that begins at a plane is taken for its lower side
// task: tile_leaf
// caught by: leaf-tile
// says: first of the upper side
    while (is_inner(nodes[id], work)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at <= nodes[id].split_pos ? 0 : 1);
    }
