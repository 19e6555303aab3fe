// mutant: counts by itself, and the leaf, too
// task: tile_leaf
// caught by: leaf-steps
// says: leaf is counted
    do {
        count_node(work);
        if (nodes[id].split_axis == KD_LEAF) {
            break;
        }
        const int at = nodes[id].split_axis == 0 ? x : y;
        id = nodes[id].first + (at < nodes[id].split_pos ? 0 : 1);
    } while (1);
