// See sah_oracle.h.
#include "sah_oracle.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

// ---- What a split costs -------------------------------------------------------------------------

static double stand_in_area(BBox3D box, u32 LOT)
{
#include "08-surface-area-heuristic/surface_area.c"
}

double sah_size(BBox3D box, SahMeasure measure)
{
    const double x = (double)box.max[0] - box.min[0];
    const double y = (double)box.max[1] - box.min[1];
    const double z = (double)box.max[2] - box.min[2];
    switch (measure) {
    case SAH_AREA:
        return 2 * (x * y + y * z + z * x);
    case SAH_HALF_AREA:
        return x * y + y * z + z * x;
    case SAH_EDGES:
        return 4 * (x + y + z);
    case SAH_SIDES:
        return x + y + z;
    case SAH_VOLUME:
        return x * y * z;
    case SAH_WITHOUT_X:
        return 2 * (x * y + z * x);
    case SAH_WITHOUT_Y:
        return 2 * (x * y + y * z);
    case SAH_WITHOUT_Z:
        return 2 * (y * z + z * x);
    case SAH_SAME:
        return 1;
    case SAH_STAND_IN:
        break;
    }
    return NAN;  // only rules know it: size_by()
}

static double size_by(BBox3D box, const SahRules *rules)
{
    return rules->measure == SAH_STAND_IN ? stand_in_area(box, rules->lot)
                                          : sah_size(box, rules->measure);
}

static double stand_in_cost(BBox3D box, SahPlane split, u32 n_lower, u32 n_higher, u32 LOT)
{
#include "08-surface-area-heuristic/split_cost.c"
}

double sah_cost(CostJob split, const SahRules *rules)
{
    if (rules->is_stand_in) {
        const SahPlane plane = {.axis = split.axis, .pos = split.pos};
        return stand_in_cost(split.box, plane, split.n_lower, split.n_higher, rules->lot);
    }
    BBox3D lower = split.box, higher = split.box;
    lower.max[split.axis] = higher.min[split.axis] = split.pos;
    const double n_lower = rules->counts_swapped ? split.n_higher : split.n_lower;
    const double n_higher = rules->counts_swapped ? split.n_lower : split.n_higher;
    double n_expected = rules->higher_only ? 0 : size_by(lower, rules) * n_lower;
    n_expected += rules->lower_only ? 0 : size_by(higher, rules) * n_higher;
    const double all = size_by(split.box, rules);
    const double both = size_by(lower, rules) + size_by(higher, rules) - all;
    n_expected += rules->lower_tests ? size_by(higher, rules) * n_higher : 0;
    n_expected -= rules->no_both ? both * n_lower : 0;
    n_expected /= rules->no_division ? 1 : rules->shares_of_sum ? all + both : all;
    if (rules->all_multiplied) {
        return (SAH_TRAVERSAL + SAH_TEST) * n_expected;
    }
    const double traversal = rules->constants_swapped ? SAH_TEST : SAH_TRAVERSAL;
    const double test = rules->constants_swapped ? SAH_TRAVERSAL : rules->no_test ? 1 : SAH_TEST;
    return (rules->no_traversal ? 0 : traversal) + test * n_expected;
}

// ---- Planes -------------------------------------------------------------------------------------

f32 sah_plane(BBox3D box, u32 axis, int i)
{
    const f32 side = box.max[axis] - box.min[axis];
    return box.min[axis] + side * ((f32)i / SAH_BINS);
}

int sah_plane_number(BBox3D box, u32 axis, f32 pos)
{
    int i = SAH_BINS - 1;
    while (i > 0 && sah_plane(box, axis, i) != pos) {
        i--;
    }
    return i;
}

// Is a sphere in the children at a plane?
typedef struct Sides {
    int is_lower, is_higher;    // as float rounds its range
    int may_lower, may_higher;  // one way of rounding says so
    int must_lower, must_higher;
} Sides;

static Sides sides_of(Sphere sphere, u32 axis, f32 plane, const SahRules *rules)
{
    const f32 centre = axis == 0 ? sphere.x : axis == 1 ? sphere.y : sphere.z;
    const f32 size = rules->signed_radius ? sphere.radius : fabsf(sphere.radius);
    const f32 radius = rules->by_centre ? 0 : size;
    const f32 begin = centre - radius, end = centre + radius;
    const double exact_begin = (double)centre - radius, exact_end = (double)centre + radius;
    const int is_lower = rules->begin_above ? begin < plane : begin <= plane;
    const int is_higher = rules->end_below ? end > plane : end >= plane;
    return (Sides){is_lower,
                   is_higher,
                   is_lower || exact_begin <= plane,
                   is_higher || exact_end >= plane,
                   is_lower && exact_begin <= plane,
                   is_higher && exact_end >= plane};
}

SahPlane sah_weigh(const SahNode *node, u32 axis, int i, const SahRules *rules)
{
    const f32 pos = sah_plane(node->box, axis, i);
    CostJob split = {node->box, axis, pos, 0, 0}, least = split, most = split;
    for (u32 j = 0; j < node->n_ids; j++) {
        const u32 id = rules->all_spheres_id ? j : node->ids[j];
        const Sides sides = sides_of(node->spheres[id], axis, pos, rules);
        const int is_sure = node->may_lack == NULL || !node->may_lack[j];
        split.n_lower += (u32)sides.is_lower;
        split.n_higher += (u32)(rules->rest_is_higher ? !sides.is_lower : sides.is_higher);
        least.n_lower += (u32)(sides.must_lower && is_sure);
        least.n_higher += (u32)(sides.must_higher && is_sure);
        most.n_lower += (u32)sides.may_lower;
        most.n_higher += (u32)sides.may_higher;
    }
    return (SahPlane){axis, pos, sah_cost(split, rules), sah_cost(least, rules),
                      sah_cost(most, rules)};
}

static u32 longest_axis(BBox3D box)
{
    u32 longest = 0;
    for (u32 axis = 1; axis < 3; axis++) {
        if (box.max[axis] - box.min[axis] > box.max[longest] - box.min[longest]) {
            longest = axis;
        }
    }
    return longest;
}

static int is_better(double cost, double best, const SahRules *rules)
{
    if (rules->highest_cost) {
        return isinf(best) || cost > best;
    }
    return rules->last_of_equals ? cost <= best : cost < best;
}

SahPlane sah_best(const SahNode *node, const SahRules *rules)
{
    SahPlane best = {.cost = INFINITY, .least = INFINITY, .most = INFINITY};
    if (sah_size(node->box, SAH_AREA) == 0 && !rules->is_stand_in) {
        return best;
    }
    for (u32 axis = 0; axis < 3; axis++) {
        const int is_left_out = (rules->longest_only && axis != longest_axis(node->box)) ||
                                (rules->no_y && axis == 1) || (rules->no_z && axis == 2);
        const int first = rules->without_first ? 2 : 1;
        const int end = rules->without_last ? SAH_BINS - 1 : SAH_BINS;
        if (rules->last_axis) {
            best = (SahPlane){.cost = INFINITY, .least = INFINITY, .most = INFINITY};
        }
        for (int i = is_left_out ? end : first; i < end; i++) {
            const SahPlane plane = sah_weigh(node, axis, i, rules);
            const double least = fmin(best.least, plane.least);
            const double most = fmin(best.most, plane.most);
            if (is_better(plane.cost, best.cost, rules)) {
                best = plane;
            }
            best.least = least;
            best.most = most;
        }
    }
    return best;
}

int sah_is_tied(const SahNode *node, const SahPlane *best)
{
    static const SahRules right = {0};
    for (u32 axis = 0; axis < 3; axis++) {
        for (int i = 1; i < SAH_BINS; i++) {
            const SahPlane plane = sah_weigh(node, axis, i, &right);
            const int is_other = plane.axis != best->axis || plane.pos != best->pos;
            if (is_other && plane.least <= best->most * (1 + 2 * SAH_COST_TOLERANCE)) {
                return 1;
            }
        }
    }
    return 0;
}
