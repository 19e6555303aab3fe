// Lab 07's kernel, writing down the steps of a ray (steps.h).
//
// Started by record.c.
#include "kdtree3d.h"
#include "spheres.h"
#include "todo.h"

uint near_side(KdNode3 node, float origin, float inverse);
int children_on_ray(KdNode3 node, float origin, float inverse, float t_min, float t_max,
                    float *t_split);

// In trace(): the node at hand with its part of the ray, the nearest hit so far, and who waits.
#define count_node(work) step_visit(work, STEP_NODE, at, hit, &todo)
#define count_leaf(work) step_visit(work, STEP_LEAF, at, hit, &todo)
static inline void step_visit(Work *work, uint kind, TodoEntry at, Hit hit, const Todo *todo)
{
    Step step = {.kind = kind,
                 .id = at.node,
                 .n_waiting = todo->n,
                 .t_min = at.t_min,
                 .t_max = at.t_max,
                 .nearest = hit.t};
    // A student's stack may hold more than there is room for.
    for (uint i = 0; i < MAX_STEP_WAITING && i < todo->n && todo->n <= TODO_SIZE; i++) {
        const TodoEntry entry = todo->entries[todo->n - 1 - i];
        step.waiting[i].node = entry.node;
        step.waiting[i].t_min = entry.t_min;
        step.waiting[i].t_max = entry.t_max;
    }
    step_add(work, step);
}

static inline void count_waiting(Work *work, uint n_waiting)
{
    work->stack_depth = max(work->stack_depth, n_waiting);
}

// What was decided at each inner node: its functions are asked again, with what was at hand.
static void steps_decide(Work *work, Ray ray, global const KdNode3 *nodes)
{
    for (uint i = 0; i < steps_kept(work->n_steps); i++) {
        Step *step = &work->steps[i];
        if (step->kind == STEP_NODE) {
            const KdNode3 node = nodes[step->id];
            const float origin = component(ray.origin, node.split_axis);
            const float inverse = 1.0f / component(ray.direction, node.split_axis);
            float t_split = NAN;
            step->side = near_side(node, origin, inverse);
            step->met = children_on_ray(node, origin, inverse, step->t_min, step->t_max, &t_split);
            step->t_split = t_split;
        }
    }
}

#define work_save(work, x, y, width, d_work)                                                       \
    (steps_decide(&work, ray, nodes), steps_save(&work, ray, hit, d_work))

#include "render_kdtree.cl"
