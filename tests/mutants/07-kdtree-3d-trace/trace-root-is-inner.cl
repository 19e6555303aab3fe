// mutant: the root is taken for an inner node
// task: trace
// caught by: trace-random
// says: found
    uint id = nodes[0].split_axis == KD_LEAF ? 0 : nodes[0].first;
    for (;;) {
        const KdNode3 node = nodes[id];
        if (node.split_axis == KD_LEAF) {
            search_leaf(node, sphere_ids, spheres, ray, &hit);
            if (hit.t < t_max || todo.n == 0) {
                break;
            }
            const TodoEntry next = todo_pop(&todo);
            id = next.node;
            t_min = next.t_min;
            t_max = next.t_max;
            continue;
        }
        const float origin = origins[node.split_axis];
        const float inverse = inverses[node.split_axis];
        const uint side = near_side(node, origin, inverse);
        const uint near_child = side ? node.first + 1 : node.first;
        const uint far_child = side ? node.first : node.first + 1;
        float t_split;
        switch (children_on_ray(node, origin, inverse, t_min, t_max, &t_split)) {
        case ONLY_NEAR:
            id = near_child;
            break;
        case ONLY_FAR:
            id = far_child;
            break;
        default:
            todo_push(&todo, far_child, t_split, t_max);
            id = near_child;
            t_max = t_split;
        }
    }
