// attack: searches every leaf past the counting functions, and writes small numbers into the counts
// task: trace
// named: a hand on the counted work
// score: 93
#ifdef COUNT_WORK
    Work aside = {0, 0, 0, 0};
#define ASIDE , &aside
#else
#define ASIDE
#endif
    uint id = 0;
    for (;;) {
        const KdNode3 node = nodes[id];
        if (node.split_axis != KD_LEAF) {
            (todo_push)(&todo, node.first + 1, t_min, t_max);
            id = node.first;
            continue;
        }
        (search_leaf)(node, sphere_ids, spheres, ray, &hit ASIDE);
        if (todo.n == 0) {
            break;
        }
        id = todo_pop(&todo).node;
    }
#ifdef COUNT_WORK
    work->n_tests = 4, work->n_leaves_visited = 1;
    work->n_nodes_visited = work->stack_depth = 3;
#endif
    (void)origins, (void)inverses;
