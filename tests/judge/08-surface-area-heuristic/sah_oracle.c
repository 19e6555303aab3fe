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
    case SAH_EDGES:
        return 4 * (x + y + z);
    case SAH_VOLUME:
        return x * y * z;
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

// The children's sizes, and how many spheres they have.
typedef struct Children {
    double lower, higher;
    double n_lower, n_higher;
} Children;

static Children children_of(CostJob split, const SahRules *rules)
{
    const u32 axis = rules->cut_across_x ? 0 : split.axis;
    BBox3D lower = split.box, higher = split.box;
    lower.max[axis] = rules->lower_uncut ? lower.max[axis] : split.pos;
    higher.min[axis] = rules->higher_uncut ? higher.min[axis] : split.pos;
    Children children = {size_by(lower, rules), size_by(higher, rules), split.n_lower,
                         split.n_higher};
    if (rules->flat_is_missed) {
        children.lower *= split.pos > split.box.min[axis];
        children.higher *= split.pos < split.box.max[axis];
    }
    if (rules->one_at_least) {
        children.n_lower = fmax(children.n_lower, 1);
        children.n_higher = fmax(children.n_higher, 1);
    }
    return children;
}

double sah_cost(CostJob split, const SahRules *rules)
{
    if (rules->is_stand_in) {
        const SahPlane plane = {.axis = split.axis, .pos = split.pos};
        return stand_in_cost(split.box, plane, split.n_lower, split.n_higher, rules->lot);
    }
    const Children children = children_of(split, rules);
    const double n_lower = rules->counts_swapped ? children.n_higher : children.n_lower;
    const double n_higher = rules->counts_swapped ? children.n_lower : children.n_higher;
    const double lower = children.lower, higher = children.higher;
    const double all = size_by(split.box, rules), both = lower + higher - all;
    double n_expected = rules->higher_only ? 0 : lower * n_lower;
    n_expected += rules->lower_only ? 0 : higher * n_higher;
    n_expected += rules->lower_tests ? higher * n_higher : 0;
    n_expected -= rules->no_both ? both * n_lower : rules->higher_is_rest ? both * n_higher : 0;
    n_expected /= rules->no_division ? 1 : rules->shares_of_sum ? all + both : all;
    n_expected = rules->whole_tests ? trunc(n_expected) : n_expected;
    if (rules->all_multiplied) {
        return (SAH_TRAVERSAL + SAH_TEST) * n_expected;
    }
    const int is_empty = split.n_lower == 0 || split.n_higher == 0;
    const int is_none = split.n_lower == 0 && split.n_higher == 0;
    const double bonus = is_empty ? 1 - rules->bonus : 1;
    const int is_free = rules->no_traversal || (is_empty && rules->empty_saves_step) ||
                        (is_none && rules->none_saves_step);
    const double traversal = rules->constants_swapped ? SAH_TEST : SAH_TRAVERSAL;
    const double test = rules->constants_swapped ? SAH_TRAVERSAL : rules->no_test ? 1 : SAH_TEST;
    return (is_free ? 0 : traversal) * (rules->bonus_of_tests ? 1 : bonus) +
           bonus * test * n_expected;
}

// ---- Planes -------------------------------------------------------------------------------------

// Candidate plane number i, rounded as float does.
static f32 plane_at(BBox3D box, u32 axis, int i)
{
    const f32 side = box.max[axis] - box.min[axis];
    return box.min[axis] + side * ((f32)i / SAH_BINS);
}

int sah_plane_number(BBox3D box, u32 axis, f32 pos)
{
    int i = SAH_BINS - 1;
    while (i > 0 && plane_at(box, axis, i) != pos) {
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

static f32 sphere_begin(Sphere sphere, u32 axis)
{
    const f32 centre = axis == 0 ? sphere.x : axis == 1 ? sphere.y : sphere.z;
    return centre - fabsf(sphere.radius);
}

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

// How many spheres the children at a plane have, by the rules.
typedef struct Counts {
    u32 n_lower, n_higher;
} Counts;

//   sides   of the sphere, at plane number i
static void count_sphere(Counts *counts, const SahNode *node, Sphere sphere, u32 axis, int i,
                         const Sides *sides, const SahRules *rules)
{
    int is_lower = sides->is_lower, is_higher = sides->is_higher;
    if (rules->begin_in_cell) {
        is_lower &= sphere_begin(sphere, axis) >= node->box.min[axis];
    }
    if (rules->ends_late) {
        is_higher =
            i == 1 || sides_of(sphere, axis, plane_at(node->box, axis, i - 1), rules).is_higher;
    }
    if (rules->begins_late || rules->begins_early || rules->ends_early) {
        const Sides first = sides_of(sphere, axis, plane_at(node->box, axis, 1), rules);
        const Sides before = sides_of(sphere, axis, plane_at(node->box, axis, i - 1), rules);
        const Sides behind = sides_of(sphere, axis, plane_at(node->box, axis, i + 1), rules);
        const int is_last = i == SAH_BINS - 1;
        if (rules->begins_late) {
            is_lower = i > 1 && before.is_lower;
        }
        // Bin 0 is never read then.
        if (rules->ends_early) {
            is_higher = (!is_last && behind.is_higher) || !first.is_higher;
        }
        if (rules->begins_early) {
            is_lower = (is_last || behind.is_lower) && !first.is_lower;
        }
    }
    counts->n_lower += (u32)is_lower;
    counts->n_higher += (u32)(rules->higher_keeps     ? 1
                              : rules->rest_is_higher ? !is_lower
                                                      : is_higher);
}

static Counts count_spheres(const SahNode *node, u32 axis, int i, const SahRules *rules)
{
    Counts counts = {0};
    for (u32 j = 0; j < node->n_ids; j++) {
        const Sphere sphere = node->spheres[rules->all_spheres_id ? j : node->ids[j]];
        const Sides sides = sides_of(sphere, axis, plane_at(node->box, axis, i), rules);
        count_sphere(&counts, node, sphere, axis, i, &sides, rules);
    }
    return counts;
}

// What bins that are not cleared between two axes make of the counts.
static void carry_over(Counts *counts, const SahNode *node, u32 axis, int i, const SahRules *rules)
{
    for (u32 before = 0; before < axis; before++) {
        const Counts more = count_spheres(node, before, i, rules);
        counts->n_lower += more.n_lower;
        // As many fewer as have ended there, though it be fewer than none.
        counts->n_higher -= node->n_ids - more.n_higher;
    }
}

SahPlane sah_weigh(const SahNode *node, u32 axis, int i, const SahRules *rules)
{
    const f32 pos = plane_at(node->box, axis, i);
    CostJob split = {node->box, axis, pos, 0, 0}, least = split, most = split;
    Counts counts = {0};
    for (u32 j = 0; j < node->n_ids; j++) {
        const Sphere sphere = node->spheres[rules->all_spheres_id ? j : node->ids[j]];
        const Sides sides = sides_of(sphere, axis, pos, rules);
        const int is_sure = node->may_lack == NULL || !node->may_lack[j];
        count_sphere(&counts, node, sphere, axis, i, &sides, rules);
        least.n_lower += (u32)(sides.must_lower && is_sure);
        least.n_higher += (u32)(sides.must_higher && is_sure);
        most.n_lower += (u32)sides.may_lower;
        most.n_higher += (u32)sides.may_higher;
    }
    if (rules->carried_over) {
        carry_over(&counts, node, axis, i, rules);
    }
    if (i == 0 || i == SAH_BINS) {  // on the border: the bins before it are none, or all
        counts = (Counts){i == 0 ? 0 : node->n_ids, i == 0 ? node->n_ids : 0};
    }
    split.n_lower = counts.n_lower;
    split.n_higher = counts.n_higher;
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

static int is_better(const SahPlane *plane, const SahPlane *best, const SahRules *rules)
{
    const int is_same_axis = plane->axis == best->axis;
    const double limit = best->cost * (1 - rules->least_share) - rules->least_gain;
    if (rules->highest_cost) {
        return isinf(best->cost) || plane->cost > best->cost;
    }
    return rules->last_of_equals || (rules->later_axis && !is_same_axis) ||
                   (rules->later_plane && is_same_axis)
               ? plane->cost <= best->cost
               : plane->cost < limit;
}

// Is plane number i left out?
static int is_left_out(const SahNode *node, const SahPlane *plane, int i, const SahRules *rules)
{
    const Counts counts =
        rules->no_empty ? count_spheres(node, plane->axis, i, rules) : (Counts){1, 1};
    return counts.n_lower == 0 || counts.n_higher == 0 ||
           (rules->below_leaf && plane->cost >= SAH_TEST * node->n_ids);
}

SahPlane sah_best(const SahNode *node, const SahRules *rules)
{
    SahPlane best = {.cost = INFINITY, .least = INFINITY, .most = INFINITY};
    if (sah_size(node->box, SAH_AREA) == 0 && !rules->is_stand_in) {
        return best;
    }
    for (u32 axis = 0; axis < 3; axis++) {
        const int is_skipped = (rules->longest_only && axis != longest_axis(node->box)) ||
                               (rules->no_y && axis == 1) || (rules->no_z && axis == 2);
        const int first = 1 + rules->without_first - rules->from_border;
        const int end = SAH_BINS - rules->without_last + rules->to_border;
        double before = INFINITY;
        if (rules->last_axis) {
            best = (SahPlane){.cost = INFINITY, .least = INFINITY, .most = INFINITY};
        }
        for (int i = is_skipped ? end : first; i < end; i++) {
            const SahPlane plane = sah_weigh(node, axis, i, rules);
            const double least = fmin(best.least, plane.least);
            const double most = fmin(best.most, plane.most);
            if (!is_left_out(node, &plane, i, rules) && is_better(&plane, &best, rules)) {
                best = plane;
            }
            best.least = least;
            best.most = most;
            if (rules->stops_rising && plane.cost > before) {
                break;
            }
            before = plane.cost;
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
