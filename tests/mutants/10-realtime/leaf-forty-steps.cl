// mutant: the search ends after 40 steps
// task: tile_leaf
// caught by: leaf-tile
// says: ended after some steps
    int n_steps = 0;
    while (is_inner(nodes[id], work) && n_steps++ < 40) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
