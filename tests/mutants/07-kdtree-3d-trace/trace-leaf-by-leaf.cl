// mutant: every leaf is searched, whether the ray meets it or not
// task: trace
// caught by: trace-early-end
// says: expected at most
    (void)origins, (void)inverses, (void)todo;
    // Breadth-first order without gaps: the last node is the last child.
    uint n_nodes = 1;
    for (uint id = 0; id < n_nodes; id++) {
        if (nodes[id].split_axis == KD_LEAF) {
            search_leaf(nodes[id], sphere_ids, spheres, ray, &hit);
        } else {
            n_nodes = nodes[id].first + 2;
        }
    }
