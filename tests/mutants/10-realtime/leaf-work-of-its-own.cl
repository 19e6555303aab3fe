// mutant: a Work of its own
// task: tile_leaf
// caught by: leaf-steps
// says: passed on
    Work own = {0, 0, 0, 0};
    while (is_inner(nodes[id], &own)) {
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
