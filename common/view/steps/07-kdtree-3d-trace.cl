// Lab 07's kernel, writing down the steps of a ray (steps.h).
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Started by record.c.
#include "kdtree3d.h"
#include "spheres.h"
#include "todo.h"

// In trace(): the node at hand with its part of the ray, the nearest hit so far, and who waits.
#define count_node(work) step_visit(work, STEP_NODE, at, hit, todo.n)
#define count_leaf(work) step_visit(work, STEP_LEAF, at, hit, todo.n)
#define count_waiting(work, n_waiting)
static inline void step_visit(Work *work, uint kind, TodoEntry at, Hit hit, uint n_waiting)
{
    const Step step = {kind, at.node, n_waiting, at.t_min, at.t_max, hit.t, 0, {0}};
    step_add(work, step);
}

#include "render_kdtree.cl"
