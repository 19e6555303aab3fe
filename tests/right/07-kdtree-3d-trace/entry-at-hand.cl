// right: the node at hand is an entry like those that wait; the far child alone is a swap
// task: trace
    TodoEntry at = {0, t_min, t_max};
    int is_searching = 1;
    while (is_searching) {
        const KdNode3 node = nodes[at.node];
        if (node.split_axis != KD_LEAF) {
            float t_split;
            const float origin = origins[node.split_axis];
            const float inverse = inverses[node.split_axis];
            uint first = node.first + near_side(node, origin, inverse);
            uint second = node.first + (first == node.first);
            const int which =
                children_on_ray(node, origin, inverse, at.t_min, at.t_max, &t_split);
            if (which == ONLY_FAR) {
                first = second;
            } else if (which == BOTH) {
                todo_push(&todo, second, t_split, at.t_max);
                at.t_max = t_split;
            }
            at.node = first;
        } else {
            if (node.n_spheres > 0) {
                search_leaf(node, sphere_ids, spheres, ray, &hit);
            }
            is_searching = hit.t >= at.t_max && todo.n > 0;
            if (is_searching) {
                at = todo_pop(&todo);
            }
        }
    }
