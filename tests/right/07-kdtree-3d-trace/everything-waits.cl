// right: every node goes through the stack: pushed by its parent, popped by the loop
// task: trace
    todo_push(&todo, 0, t_near, t_far);
    while (todo.n > 0) {
        const TodoEntry entry = todo_pop(&todo);
        const KdNode3 node = nodes[entry.node];
        if (node.split_axis == KD_LEAF) {
            search_leaf(node, sphere_ids, spheres, ray, &hit);
            if (hit.t <= entry.t_far) {
                break;
            }
            continue;
        }
        const float origin = origins[node.split_axis];
        const float inverse = inverses[node.split_axis];
        const uint side = near_side(node, origin, inverse);
        float t_split = entry.t_far;
        const int which =
            children_on_ray(node, origin, inverse, entry.t_near, entry.t_far, &t_split);
        if (which == ONLY_FAR) {
            todo_push(&todo, node.first + 1 - side, entry.t_near, entry.t_far);
        } else if (which == ONLY_NEAR) {
            todo_push(&todo, node.first + side, entry.t_near, entry.t_far);
        } else {
            // The far one first: what is pushed last comes back first.
            todo_push(&todo, node.first + 1 - side, t_split, entry.t_far);
            todo_push(&todo, node.first + side, entry.t_near, t_split);
        }
    }
