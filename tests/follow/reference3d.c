// A ray among spheres, followed in double precision (see reference_steps.h).
//
// How far may a right kernel's float be off? The ray's direction is, by its direction_error, on
// each axis; so of a plane that is met at t = (plane - origin) / direction, t is off by
//     t (direction_error / |direction| + 4 u) + 2 u (|plane| + |origin|) / |direction|,   u = 2^-24
// Where two numbers that are compared lie nearer to each other, rounding decides, and the step is
// close.
#include "oracle3d.h"
#include "oracle3d_rounding.h"
#include "reference_steps.h"

#include <math.h>

static const OracleRules3D RIGHT = {0};

// A number, and by how much float may be off.
typedef struct Rounded {
    double value, slack;
} Rounded;

// A node with the part of the ray inside it.
typedef struct Visit {
    u32 node;
    Rounded t_min, t_max;
} Visit;

typedef struct Search {
    const WorldData *data;
    OracleRay ray;
    double origin[3], direction[3];
    Visit waiting[TODO_SIZE];
    u32 n_waiting;
    OracleRoot root;  // of the nearest hit so far
    u32 sphere;       // and whose it is
    Steps *steps;
} Search;

static int is_close(Rounded a, Rounded b)
{
    return fabs(a.value - b.value) <= a.slack + b.slack;
}

// Where the ray meets a plane at right angles to an axis, which it is not along.
static Rounded plane_met(const Search *search, u32 axis, double plane)
{
    const double o = search->origin[axis], d = search->direction[axis];
    const double t = (plane - o) / d;
    return (Rounded){t, fabs(t) * (search->ray.direction_error / fabs(d) + 4 * ROUNDING) +
                            2 * ROUNDING * (fabs(plane) + fabs(o)) / fabs(d)};
}

// ---- Steps --------------------------------------------------------------------------------------

static Step visit_step(const Search *search, u32 kind, const Visit *at)
{
    Step step = {
        .kind = kind,
        .id = at->node,
        .n_waiting = search->n_waiting,
        .t_min = (f32)at->t_min.value,
        .t_max = (f32)at->t_max.value,
        .nearest = (f32)search->root.t,
        .t_split = NAN,
        .slack = (f32)fmax(at->t_min.slack, at->t_max.slack),
    };
    for (u32 i = 0; i < MAX_STEP_WAITING && i < search->n_waiting; i++) {
        const Visit *entry = &search->waiting[search->n_waiting - 1 - i];
        step.slack = fmaxf(step.slack, (f32)fmax(entry->t_min.slack, entry->t_max.slack));
        step.waiting[i] =
            (StepWaiting){entry->node, (f32)entry->t_min.value, (f32)entry->t_max.value};
    }
    return step;
}

static void ask(Search *search, u32 id)
{
    const Sphere sphere = search->data->spheres[id];
    const OracleRoot root = oracle3d_root(sphere, &search->ray, ORACLE_PROJECTION, &RIGHT);
    Step step = {.kind = STEP_TEST,
                 .id = id,
                 .answer = (f32)root.t,
                 .element = {sphere.x, sphere.y, sphere.z, sphere.radius},
                 .is_close = root.is_possible && !root.is_certain};
    if (root.t < INFINITY) {
        step.slack = (f32)fmax(root.t_high - root.t, root.t - root.t_low);
    }
    reference_add(search->steps, step);
    const int is_tie = root.t < INFINITY && root.t == search->root.t;
    if (root.t < search->root.t || (is_tie && id < search->sphere)) {
        search->root = root;
        search->sphere = id;
    }
}

// ---- The search ---------------------------------------------------------------------------------

// The part of the ray in the tree's box. Returns 0 where there is none.
static int enter(const Search *search, Visit *at)
{
    *at = (Visit){0, {0, 0}, {INFINITY, 0}};
    for (u32 axis = 0; axis < 3; axis++) {
        const double low = search->data->bounds.min[axis], high = search->data->bounds.max[axis];
        if (search->direction[axis] == 0) {
            if (search->origin[axis] < low || search->origin[axis] > high) {
                return 0;
            }
            continue;
        }
        const int is_up = search->direction[axis] > 0;
        const Rounded entry = plane_met(search, axis, is_up ? low : high);
        const Rounded exit = plane_met(search, axis, is_up ? high : low);
        at->t_min = entry.value > at->t_min.value ? entry : at->t_min;
        at->t_max = exit.value < at->t_max.value ? exit : at->t_max;
    }
    return at->t_min.value <= at->t_max.value;
}

// Which children does the ray meet, and where the plane? Sets side, met, t_split and is_close.
static Rounded decide(const Search *search, KdNode3 node, const Visit *at, Step *step)
{
    const double o = search->origin[node.split_axis], d = search->direction[node.split_axis];
    const double ahead = node.split_pos - o;
    step->side = ahead == 0 ? d > 0 : ahead < 0;
    step->met = MET_NEAR;
    const Rounded t_split =
        d == 0 ? (Rounded){INFINITY, 0} : plane_met(search, node.split_axis, node.split_pos);
    if (t_split.value > 0 && t_split.value <= at->t_max.value) {
        step->met = t_split.value < at->t_min.value ? MET_FAR : MET_BOTH;
        step->t_split = (f32)t_split.value;
        step->slack = fmaxf(step->slack, (f32)t_split.slack);
    }
    step->is_close = d != 0 && (is_close(t_split, at->t_max) || is_close(t_split, at->t_min) ||
                                is_close(t_split, (Rounded){0, 0}));
    return t_split;
}

// From an inner node to the child that comes next.
static void go_down(Search *search, KdNode3 node, Visit *at)
{
    Step step = visit_step(search, STEP_NODE, at);
    const Rounded t_split = decide(search, node, at, &step);
    reference_add(search->steps, step);
    const u32 near_child = node.first + step.side, far_child = node.first + 1 - step.side;
    if (step.met == MET_BOTH) {
        search->waiting[search->n_waiting++] = (Visit){far_child, t_split, at->t_max};
        at->t_max = t_split;
    }
    at->node = step.met == MET_FAR ? far_child : near_child;
    if (search->steps->stack_depth < search->n_waiting) {
        search->steps->stack_depth = search->n_waiting;
    }
}

// From a leaf to what waits. Returns 0 where the search is over.
static int come_back(Search *search, KdNode3 leaf, Visit *at)
{
    search->steps->n_leaves_visited++;
    reference_add(search->steps, visit_step(search, STEP_LEAF, at));
    for (u32 i = 0; i < leaf.n_spheres; i++) {
        ask(search, search->data->tree3d->sphere_ids[leaf.first + i]);
    }
    const OracleRoot *hit = &search->root;
    if (hit->is_possible && search->steps->n_steps < MAX_STEPS) {
        // Behind the leaf rounding may decide whether the search ends.
        const double slack = fmax(hit->t_high - hit->t, hit->t - hit->t_low);
        Step *last = &search->steps->steps[search->steps->n_steps - 1];
        last->is_close |= (u32)is_close((Rounded){hit->t, slack}, at->t_max);
    }
    if (hit->t < at->t_max.value || search->n_waiting == 0) {
        return 0;
    }
    *at = search->waiting[--search->n_waiting];
    return 1;
}

static void search_tree(Search *search)
{
    Visit at;
    int goes_on = enter(search, &at);
    while (goes_on) {
        const KdNode3 node = search->data->tree3d->nodes[at.node];
        if (node.split_axis == KD_LEAF) {
            goes_on = come_back(search, node, &at);
        } else {
            go_down(search, node, &at);
        }
    }
}

void reference3d_follow(const World *world, int x, int y, Steps *steps)
{
    const WorldData data = world->kind->data(world);
    Search search = {
        .data = &data,
        .ray = oracle3d_primary_ray(&data.camera, x, y, world->width, world->height, &RIGHT),
        .root = {.t = INFINITY},
        .sphere = NO_ID,
        .steps = steps,
    };
    const OracleVector o = search.ray.origin, d = search.ray.direction;
    const double origin[3] = {o.x, o.y, o.z}, direction[3] = {d.x, d.y, d.z};
    for (int axis = 0; axis < 3; axis++) {
        search.origin[axis] = origin[axis];
        search.direction[axis] = direction[axis];
        steps->origin[axis] = (f32)origin[axis];
        steps->direction[axis] = (f32)direction[axis];
    }
    if (data.tree3d != NULL) {
        search_tree(&search);
    } else {
        for (u32 id = 0; id < (u32)world->n_elements; id++) {
            ask(&search, id);
        }
    }
    Step end = {.kind = STEP_END, .id = search.sphere, .nearest = (f32)search.root.t};
    if (search.root.is_possible) {
        end.slack =
            (f32)fmax(search.root.t_high - search.root.t, search.root.t - search.root.t_low);
    }
    reference_add(steps, end);
}
