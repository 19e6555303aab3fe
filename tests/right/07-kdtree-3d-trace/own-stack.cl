// right: a stack of one's own, of nodes and ends only: a node begins where the one before it ended
// task: trace
    uint waiting[TODO_SIZE];
    float ends[TODO_SIZE];
    int n_waiting = 0;
    uint id = 0;
    while (true) {
        const KdNode3 node = nodes[id];
        if (node.split_axis == KD_LEAF) {
            search_leaf(node, sphere_ids, spheres, ray, &hit);
            if (hit.t < t_max || n_waiting == 0) {
                break;
            }
            n_waiting--;
            t_min = t_max;
            t_max = ends[n_waiting];
            id = waiting[n_waiting];
        } else {
            const uint axis = node.split_axis;
            const uint side = near_side(node, origins[axis], inverses[axis]);
            float t_split;
            const int which =
                children_on_ray(node, origins[axis], inverses[axis], t_min, t_max, &t_split);
            id = node.first + (which == ONLY_FAR ? !side : side);
            if (which == BOTH) {
                waiting[n_waiting] = node.first + !side;
                ends[n_waiting] = t_max;
                n_waiting++;
                t_max = t_split;
            }
        }
    }
