// right: pixels and planes count from 0, so a sign is not needed
// task: tile_leaf
    while (is_inner(nodes[id], work)) {
        const uint at = nodes[id].split_axis == 0 ? (uint)x : (uint)y;
        id = nodes[id].first + (at < (uint)nodes[id].split_pos ? 0 : 1);
    }
