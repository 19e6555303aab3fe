// right: two loops: down to the leaf, and up again
// task: trace
    int is_done = 0;
    uint id = 0;
    while (!is_done) {
        KdNode3 node = nodes[id];
        while (node.split_axis != KD_LEAF) {
            float t_split = 0.0f;
            const float origin = origins[node.split_axis];
            const float inverse = inverses[node.split_axis];
            const int which = children_on_ray(node, origin, inverse, t_min, t_max, &t_split);
            const uint near_child = node.first + near_side(node, origin, inverse);
            const uint far_child = 2 * node.first + 1 - near_child;
            if (which == BOTH) {
                todo_push(&todo, far_child, t_split, t_max);
                t_max = t_split;
            }
            id = which == ONLY_FAR ? far_child : near_child;
            node = nodes[id];
        }
        search_leaf(node, sphere_ids, spheres, ray, &hit);
        is_done = hit.t < t_max || todo.n == 0;
        if (!is_done) {
            const TodoEntry next = todo_pop(&todo);
            id = next.node;
            t_min = next.t_min;
            t_max = next.t_max;
        }
    }
