// 3D: from the line that includes this header on, the steps of a search through the kd-tree are
// counted in *work of work.h, which search_leaf also gets handed.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: work.h.
#ifdef COUNT_WORK
#define children_on_ray(node, origin, inverse, t_min, t_max, t_split)                              \
    (work->n_nodes_visited++, children_on_ray(node, origin, inverse, t_min, t_max, t_split))
#define search_leaf(node, sphere_ids, spheres, ray, hit)                                           \
    (work->n_leaves_visited++, search_leaf(node, sphere_ids, spheres, ray, hit, work))
#define todo_push(todo, node, t_min, t_max)                                                        \
    (todo_push(todo, node, t_min, t_max), work->stack_depth = max(work->stack_depth, (todo)->n))
#endif
