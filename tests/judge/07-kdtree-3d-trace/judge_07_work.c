// How much work a right search does: see judge_07_work.h.
//
// search3d_bounds() is why the counted work can be judged ray by ray. It knows where each number of
// a right solution may lie: a direction's part anywhere within the ray's error (oracle3d.c, 1), and
// t_split within PLANE_ERROR (oracle3d_rounding.h) of what follows from it. Whatever may be visited
// counts for the most; the search ends only where every right one must: in a leaf that no right one
// skips, with a hit that is certain and certainly not beyond t_max. For the least counts what no
// right one skips, up to the first leaf where one of them may end. A ray along a plane may go to
// either side of it.
#include "judge_07_work.h"

#include "judge_07.h"

#include <math.h>

// Where a right solution may find that the ray meets a plane. A ray that may be along the plane
// sets *is_along: it may meet it anywhere from there on, or behind the eye as well, or nowhere.
static Span plane_span(const OracleRay *ray, u32 axis, double plane, int *is_along)
{
    const double origin = vector_component(ray->origin, axis),
                 direction = vector_component(ray->direction, axis);
    const double distance = plane - origin, error = ray->direction_error;
    const double rounding = PLANE_ERROR * (fabs(plane) + fabs(origin));
    *is_along = fabs(direction) <= error;
    if (*is_along) {
        return (Span){(fabs(distance) - rounding) / (fabs(direction) + error), INFINITY};
    }
    if (distance == 0) {
        return (Span){0, 0};  // exactly: the eye is on the plane
    }
    const double a = distance / (direction - error), b = distance / (direction + error);
    const double last = rounding / (fabs(direction) - error);
    return (Span){fmin(a, b) - last, fmax(a, b) + last};
}

typedef struct Part {
    Span t_min, t_max;
} Part;

// Narrow a part of the ray to the scene's box. Along the planes, a ray between them leaves at the
// nearer one or later, and one outside enters there or later, or never.
static void clip_span(BBox3D box, const OracleRay *ray, Part *part)
{
    for (u32 axis = 0; axis < 3; axis++) {
        const double origin = vector_component(ray->origin, axis);
        int is_along;
        const Span low = plane_span(ray, axis, box.min[axis], &is_along);
        const Span high = plane_span(ray, axis, box.max[axis], &is_along);
        if (!is_along) {
            part->t_min = span_max(part->t_min, span_min(low, high));
            part->t_max = span_min(part->t_max, span_max(low, high));
        } else if (origin >= box.min[axis] && origin <= box.max[axis]) {
            part->t_max = span_min(part->t_max, span_min(low, high));
        } else {
            part->t_min = span_max(part->t_min, span_min(low, high));
        }
    }
}

typedef struct Visits {
    const JobScene3D *scene;
    const OracleRay *ray;
    double t_certain;    // every right search that got here has a hit no farther than this
    double t_possible;   // none has a nearer one
    int may_have_ended;  // a right search may have ended by now
    u32 sought;          // a sphere,
    int may_ask;         // which a right search may have asked by now
    WorkBounds work;
} Visits;

static int visit_leaf(Visits *visits, KdNode3 leaf, Part part, int is_certain)
{
    static const OracleRules3D right = {0};
    const JobScene3D *scene = visits->scene;
    visits->work.most.n_leaves_visited++;
    visits->work.most.n_tests += leaf.n_spheres;
    if (is_certain && !visits->may_have_ended) {
        visits->work.least.n_leaves_visited += leaf.n_spheres > 0;
        visits->work.least.n_tests += leaf.n_spheres;
    }
    for (u32 i = leaf.first; i < leaf.first + leaf.n_spheres; i++) {
        const Sphere sphere = scene->scene.spheres[scene->tree.sphere_ids[i]];
        visits->may_ask |= scene->tree.sphere_ids[i] == visits->sought;
        const OracleRoot root = oracle3d_root(sphere, visits->ray, ORACLE_PROJECTION, &right);
        if (root.is_possible) {
            visits->t_possible = fmin(visits->t_possible, root.t_low);
        }
        if (is_certain && root.is_certain) {
            visits->t_certain = fmin(visits->t_certain, root.t_high);
        }
    }
    visits->may_have_ended |=
        visits->t_possible < INFINITY && visits->t_possible <= part.t_max.high;
    return is_certain && visits->t_certain <= part.t_max.low;
}

// Visit all that a right search may visit in a node.
//   is_certain   no right search that has not ended yet skips the node
//   n_waiting    how many nodes may wait meanwhile
// Returns 1 when every right search has ended by then.
static int visit(Visits *visits, u32 id, Part part, int is_certain, u32 n_waiting)
{
    const KdNode3 node = visits->scene->tree.nodes[id];
    if (node.split_axis == KD_LEAF) {
        return visit_leaf(visits, node, part, is_certain);
    }
    const double origin = vector_component(visits->ray->origin, node.split_axis);
    const double direction = vector_component(visits->ray->direction, node.split_axis);
    int is_along;
    const Span split = plane_span(visits->ray, node.split_axis, node.split_pos, &is_along);
    Work *least = &visits->work.least, *most = &visits->work.most;
    most->n_nodes_visited++;
    least->n_nodes_visited += is_certain && !visits->may_have_ended;
    if (origin == node.split_pos && is_along) {
        // With the eye on the plane either child is near, and only that one is met.
        visit(visits, node.first, part, 0, n_waiting);
        visit(visits, node.first + 1, part, 0, n_waiting);
        return 0;
    }
    const u32 side = origin < node.split_pos ? 0 : origin > node.split_pos ? 1 : direction > 0;
    const int may_meet = split.high > 0 && split.low <= part.t_max.high;
    const int must_meet = split.low > 0 && split.high <= part.t_max.low && !is_along;
    const int may_skip_near = may_meet && split.low < part.t_min.high;
    const int must_skip_near = must_meet && split.high < part.t_min.low;
    Part near = part, far = part;
    if (may_meet) {
        near.t_max.low = fmin(part.t_max.low, split.low);
        near.t_max.high = must_meet ? fmin(part.t_max.high, split.high) : part.t_max.high;
        far.t_min = span_max(part.t_min, split);
    }
    const u32 n_with_far = n_waiting + (may_meet ? 1 : 0);
    if (!must_skip_near) {
        most->stack_depth = n_with_far > most->stack_depth ? n_with_far : most->stack_depth;
        if (visit(visits, node.first + side, near, is_certain && !may_skip_near, n_with_far)) {
            return 1;
        }
    }
    return may_meet && visit(visits, node.first + !side, far, is_certain && must_meet, n_waiting);
}

static Visits search(const JobScene3D *scene, const OracleRay *ray, u32 sought)
{
    Visits visits = {.scene = scene,
                     .ray = ray,
                     .t_certain = INFINITY,
                     .t_possible = INFINITY,
                     .sought = sought};
    Part part = {{ray->t_min, ray->t_min}, {INFINITY, INFINITY}};
    clip_span(scene->tree.bounds, ray, &part);
    if (part.t_min.low <= part.t_max.high) {
        visit(&visits, 0, part, part.t_min.high <= part.t_max.low, 0);
    }
    return visits;
}

WorkBounds search3d_bounds(const JobScene3D *scene, const OracleRay *ray)
{
    return search(scene, ray, ORACLE_NO_SPHERE).work;
}

int search3d_may_ask(const JobScene3D *scene, const OracleRay *ray, u32 sphere)
{
    return search(scene, ray, sphere).may_ask;
}
