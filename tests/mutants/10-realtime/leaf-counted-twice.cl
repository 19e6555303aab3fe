// mutant: each node is asked twice
// task: tile_leaf
// caught by: leaf-steps
// says: counted twice
    while (is_inner(nodes[id], work)) {
        if (!is_inner(nodes[id], work)) {
            break;
        }
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    }
