// Lab 08: find_best_split on its inputs, and searches that err. See judge_08.h.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- A search -----------------------------------------------------------------------------------

// Where a sphere is: in the lower child of planes number `from` and up, in the higher child of
// those up to `to`.
typedef struct Reach {
    int from, to;
} Reach;
enum { NEVER = SAH_BINS + 1 };

// A plane, with the spheres of its children.
typedef struct Plane {
    CostJob split;
    double cost;
} Plane;

// A way of searching. All zeros is the right one.
typedef struct Way {
    int from_border, to_border;  // the cell's borders are asked, too
    int carries;       // the bins of an axis begin with what those of the axis before hold
    int counts_ended;  // in the place of the higher child's spheres those that it has not
    int is_stub;       // split_cost is that of tests/stubs
} Way;

static double stub_cost(BBox3D box, CostJob split, u32 n_lower, u32 n_higher, u32 NONCE)
{
#include "08-surface-area-heuristic/split_cost.c"
}

// An axis of a cell.
typedef struct Side {
    BBox3D box;
    u32 axis;
} Side;

static int from_of(Side side, f32 begin)
{
    int from = 1;
    while (from < SAH_BINS && begin > sah_plane_at(side.box, side.axis, from)) {
        from++;
    }
    return from;
}

static int to_of(Side side, f32 end)
{
    int to = SAH_BINS - 1;
    while (to > 0 && end < sah_plane_at(side.box, side.axis, to)) {
        to--;
    }
    return to;
}

static Reach reach_of(Side side, Sphere sphere)
{
    const f32 centre = sah_centre(sphere, side.axis), radius = fabsf(sphere.radius);
    return (Reach){from_of(side, centre - radius), to_of(side, centre + radius)};
}

// The planes of all axes, by their numbers, those on the borders too.
typedef struct Planes {
    Plane of[3][SAH_BINS + 1];
} Planes;

// Those of a cell, without a sphere.
static Planes planes_of(BBox3D box)
{
    Planes planes = {0};
    for (u32 axis = 0; axis < 3; axis++) {
        for (int i = 0; i <= SAH_BINS; i++) {
            planes.of[axis][i].split = (CostJob){box, axis, sah_plane_at(box, axis, i), 0, 0};
        }
    }
    return planes;
}

static void count_sphere(Planes *planes, u32 axis, Reach reach)
{
    for (int i = 1; i < SAH_BINS; i++) {
        planes->of[axis][i].split.n_lower += i >= reach.from;
        planes->of[axis][i].split.n_higher += i <= reach.to;
    }
}

// With their costs, once all spheres are counted.
static Planes weighed(const SahNode *node, Planes planes, u32 nonce, Way way)
{
    for (u32 axis = 0; axis < 3; axis++) {
        Plane *of = planes.of[axis];
        for (int i = 1; way.counts_ended && i < SAH_BINS; i++) {
            of[i].split.n_higher = node->n_ids - of[i].split.n_higher;
        }
        of[0].split.n_higher = of[SAH_BINS].split.n_lower = node->n_ids;
        for (int i = 0; i <= SAH_BINS; i++) {
            CostJob *split = &of[i].split;
            if (way.carries && axis > 0) {  // fewer than none, perhaps
                split->n_lower += planes.of[axis - 1][i].split.n_lower;
                split->n_higher += planes.of[axis - 1][i].split.n_higher - node->n_ids;
            }
            of[i].cost = way.is_stub
                             ? stub_cost(node->box, *split, split->n_lower, split->n_higher, nonce)
                             : sah_cost(*split);
        }
    }
    return planes;
}

// As a right search counts the spheres.
static Planes counted(const SahNode *node)
{
    Planes planes = planes_of(node->box);
    for (u32 axis = 0; axis < 3; axis++) {
        for (u32 j = 0; j < node->n_ids; j++) {
            const Sphere sphere = node->spheres[node->ids[j]];
            count_sphere(&planes, axis, reach_of((Side){node->box, axis}, sphere));
        }
    }
    return planes;
}

static Plane best_of(const SahNode *node, const Planes *planes, Way way)
{
    Plane best = {.cost = INFINITY};
    for (u32 axis = 0; axis < 3 && sah_area(node->box) > 0; axis++) {
        for (int i = 1 - way.from_border; i < SAH_BINS + way.to_border; i++) {
            const Plane *plane = &planes->of[axis][i];
            best = plane->cost < best.cost ? *plane : best;
        }
    }
    return best;
}

#define GIVEN                                                                                      \
    const BestJob in = ((const Job08 *)job)->bests[i];                                             \
    const BestAnswer found = ((const BestAnswer *)answers)[i]

// The input number i as a node.
static SahNode node_of(const Job08 *job, int i)
{
    const BestJob in = job->bests[i];
    return (SahNode){in.box, job->best_spheres, job->best_ids + in.first_id, NULL, in.n_ids};
}

// Is this an answer of a search that finds the plane? Of exact ties only the first one is right;
// elsewhere the costs of two planes may be so near that float takes one for the other.
static int is_search(int i, BestAnswer found, const Planes *planes, Plane best)
{
    if (best.cost == INFINITY) {
        return found.cost == INFINITY;
    }
    const int is_tie = i >= N_CELLS && i < N_CELLS + N_TIES;
    const BBox3D box = best.split.box;
    const int number = found.axis < 3 ? sah_plane_number(box, found.axis, found.pos) : 0;
    const int is_best = found.axis == best.split.axis && found.pos == best.split.pos;
    const double tolerance = SAH_COST_TOLERANCE * best.cost;
    return fabs(found.cost - best.cost) <= tolerance &&
           (is_best || (!is_tie && number > 0 &&
                        planes->of[found.axis][number].cost <= best.cost + 2 * tolerance));
}

// The same of one that counts the spheres so.
static int follows_counts(const Job08 *job, int i, BestAnswer found, Planes counts, Way way)
{
    const SahNode node = node_of(job, i);
    way.is_stub |= job->job.is_alone;
    const Planes planes = weighed(&node, counts, job->job.nonce, way);
    return is_search(i, found, &planes, best_of(&node, &planes, way));
}

static int follows(const Job08 *job, int i, BestAnswer found, Way way)
{
    const SahNode node = node_of(job, i);
    return follows_counts(job, i, found, counted(&node), way);
}

RIGHT(is_best, follows(job, i, found, (Way){0}))

// ---- Mistakes -----------------------------------------------------------------------------------

// Which plane is taken in the place of the best one so far: the `plane` number `at` of an axis.
#define TAKES_OF(name, n_ways, is_taken, ...)                                                      \
    for (int k = 0; number == 0 && has_area && k < 3 * (SAH_BINS - 1); k++) {                      \
        const u32 axis = (u32)k / (SAH_BINS - 1);                                                  \
        const int at = 1 + k % (SAH_BINS - 1);                                                     \
        const Plane *plane = &planes.of[axis][at];                                                 \
        const int is_less = plane->cost < best.cost, is_equal = plane->cost == best.cost;          \
        const int is_other_axis = axis != best.split.axis;                                         \
        (void)is_less, (void)is_equal, (void)is_other_axis;                                        \
        best = (is_taken) ? *plane : best;                                                         \
    }                                                                                              \
    ONE_OF(name, n_ways, is_search(i, found, &planes, best), __VA_ARGS__)
#define TAKES(name, is_taken, ...) TAKES_OF(name, 1, is_taken, __VA_ARGS__)

// Which planes are asked.
#define ASKS(name, is_asked, ...) TAKES(name, is_less && (is_asked), __VA_ARGS__)

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

static int rises_before(const Plane *planes, int i)
{
    int k = 2;
    while (k < i && planes[k].cost <= planes[k - 1].cost) {
        k++;
    }
    return k < i;
}

// In bins, of which the first is never read where all are looked up one behind.
static int from_early(int from)
{
    return from > 1 ? from - 1 : NEVER;
}

static int to_early(int to)
{
    return to > 0 ? to - 1 : NEVER;
}

static int above(Side side, f32 begin)
{
    return from_of(side, nextafterf(begin, INFINITY));
}

static int below(Side side, f32 end)
{
    return to_of(side, nextafterf(end, -INFINITY));
}

// On which planes a sphere counts, from `begin` to `end` on an axis.
#define COUNTS(name, from_plane, to_plane, ...)                                                    \
    for (u32 k = 0; number == 0 && k < 3 * node.n_ids; k++) {                                      \
        const Side side = {node.box, k % 3};                                                       \
        const Sphere sphere = node.spheres[node.ids[k / 3]];                                       \
        const f32 centre = sah_centre(sphere, side.axis), radius = fabsf(sphere.radius);           \
        const f32 begin = centre - radius, end = centre + radius;                                  \
        const int from = from_of(side, begin), to = to_of(side, end);                              \
        (void)from, (void)to;                                                                      \
        count_sphere(&counts, side.axis, (Reach){from_plane, to_plane});                           \
    }                                                                                              \
    EACH(name, follows_counts(job, i, found, counts, (Way){0}), __VA_ARGS__)

// What is kept of the cheapest plane.
static int is_best_with(const Job08 *job, int i, BestAnswer found, int keeps_axis, int keeps_pos)
{
    const SahNode node = node_of(job, i);
    const Way way = {.is_stub = job->job.is_alone};
    const Planes planes = weighed(&node, counted(&node), job->job.nonce, way);
    const Plane best = best_of(&node, &planes, way);
    if (best.cost == INFINITY) {
        return found.cost == INFINITY;
    }
    return fabs(found.cost - best.cost) <= SAH_COST_TOLERANCE * best.cost &&
           found.axis == (keeps_axis ? best.split.axis : 0) &&
           found.pos == (keeps_pos ? best.split.pos : 0);
}

// Of whatever search: is the plane that was found a candidate, and the cost that of this plane?
typedef enum Kept { NO_PLANE, OTHER_COST, RIGHT_COST } Kept;
static Kept kept_of(const Job08 *job, int i, BestAnswer found)
{
    const SahNode node = node_of(job, i);
    const int number = found.axis < 3 ? sah_plane_number(node.box, found.axis, found.pos) : 0;
    const double cost = number > 0 ? sah_weigh(&node, found.axis, number).cost : 0;
    return number == 0                                                 ? NO_PLANE
           : fabs(found.cost - cost) > SAH_COST_TOLERANCE * fabs(cost) ? OTHER_COST
                                                                       : RIGHT_COST;
}

KNOWN_LIST(known)
{
    GIVEN;
    const Job *base = job;
    const SahNode node = node_of(job, i);
    const int has_area = sah_area(in.box) > 0;
    const Planes planes =
        weighed(&node, counted(&node), base->nonce, (Way){.is_stub = base->is_alone});
    Planes counts = planes_of(in.box);
    Plane best = {.split.box = in.box, .cost = INFINITY};

    ASKS(longest_only, axis == longest_axis(in.box),
         "only the longest side is searched, not all three");
    ASKS(no_z, axis != 2, "planes across z are not searched");
    ASKS(no_y, axis != 1, "planes across y are not searched");
    ASKS(only_x, axis == 0, "only planes across x are searched");
    ASKS(no_first, at != 1, "the first plane is not asked");
    ASKS(no_last, at != SAH_BINS - 1, "the last plane is not asked");
    ASKS(
        stops_rising, !rises_before(planes.of[axis], at),
        "behind a plane that costs more than the one before a cheaper one may come: all are asked");
    ASKS(no_empty, plane->split.n_lower > 0 && plane->split.n_higher > 0,
         "a plane that leaves a child empty is a candidate, too");
    ASKS(below_leaf, plane->cost < SAH_TEST * in.n_ids,
         "the cheapest plane is searched, also where a leaf is cheaper: that is asked later");

#define EPSILON "a plane that is cheaper by however little is the better one: no epsilon"
    TAKES(last_of_equals, is_less || is_equal,
          "of equal costs the first plane counts: x before y before z, and the lower one first",
          MISTAKE_LATER_OF_EQUALS);
    TAKES(later_axis, is_less || (is_equal && is_other_axis),
          "of equal costs on several axes x counts before y, and y before z");
    TAKES(later_plane, is_less || (is_equal && !is_other_axis),
          "of equal costs on an axis the lower plane counts");
    TAKES(last_axis, is_less || is_other_axis,
          "the cheapest of all three axes counts, not of the last one");
    TAKES(dearest, isinf(best.cost) || plane->cost > best.cost,
          "that is the plane with the highest cost");
    static const double epsilons[] = {1e-2, 1e-3, 1e-4, 1e-5};
    TAKES_OF(gain, 4, plane->cost < best.cost - epsilons[way], EPSILON);
    TAKES_OF(share, 3, plane->cost < best.cost * (1 - epsilons[way]), EPSILON);

#define BY_CENTRE "a sphere counts by its range, not by its centre"
    COUNTS(by_centre, from_of(side, centre), to_of(side, centre), BY_CENTRE);
    COUNTS(by_centre_lower, from_of(side, centre), below(side, centre), BY_CENTRE);
    COUNTS(by_centre_higher, above(side, centre), to_of(side, centre), BY_CENTRE);
    COUNTS(begin_above, above(side, begin), to,
           "a range that begins at the plane counts in the lower child, too",
           MISTAKE_STRICT_BOUNDARY);
    COUNTS(end_below, from, below(side, end),
           "a range that ends at the plane counts in the higher child, too",
           MISTAKE_STRICT_BOUNDARY);
    COUNTS(both_strict, above(side, begin), below(side, end),
           "a range that only touches the plane counts in both children", MISTAKE_STRICT_BOUNDARY);
    COUNTS(signed_radius, from_of(side, centre - sphere.radius),
           to_of(side, centre + sphere.radius), "a negative radius counts as its absolute value");
    COUNTS(begin_in_cell, begin >= node.box.min[side.axis] ? from : NEVER, to,
           "a sphere that begins before the cell is in its lower child, too");
    COUNTS(ends_late, from, to + 1,
           "a sphere that ends in the bin before a plane is not in its higher child any more");
    COUNTS(ends_early, from, to_early(to),
           "the ends are off by one bin: who ends in the bin behind a plane is in its higher child "
           "still");
    COUNTS(begins_late, from + 1, to,
           "the begins are off by one bin: who begins in the bin before a plane is in its lower "
           "child");
    COUNTS(begins_early, from_early(from), to,
           "the begins are off by one bin: who begins in the bin behind a plane is not yet in its "
           "lower child");
    COUNTS(all_early, from_early(from), to_early(to),
           "all bins are off by one: at a plane only those before it are counted, up to bin plane "
           "- 1");
    COUNTS(
        all_late, from + 1, to + 1,
        "all bins are off by one: at a plane the bin just before it, plane - 1, is counted, too");
    COUNTS(higher_keeps, from, NEVER,
           "the higher child keeps all spheres: those that end before the plane leave it");
    COUNTS(rest_is_higher, from, from - 1,
           "a sphere over the plane is in both children: the higher one has more than the rest");

    COUNTS(unnamed, reach_of(side, node.spheres[k / 3]).from,
           reach_of(side, node.spheres[k / 3]).to,
           "the node's spheres are those that its ids name");
    EACH(border,
         follows(job, i, found, (Way){.to_border = 1}) ||
             follows(job, i, found, (Way){.from_border = 1}) ||
             follows(job, i, found, (Way){.from_border = 1, .to_border = 1}),
         "the border of the cell is asked, too: only planes within the cell are candidates");
    EACH(carried_over, follows(job, i, found, (Way){.carries = 1}),
         "the bins of an axis begin with what those of the axis before hold, not with 0");

    EACH(ended_counted, follows(job, i, found, (Way){.counts_ended = 1}),
         "who has ended before a plane has left the higher child: it has the others");

    EACH(pos_lost, is_best_with(job, i, found, 1, 0),
         "the cheapest plane's cost and axis are kept, but not its position");
    EACH(axis_lost, is_best_with(job, i, found, 0, 1),
         "the cheapest plane's cost and position are kept, but not its axis");
    EACH(plane_lost, is_best_with(job, i, found, 0, 0),
         "the cheapest plane's cost is kept, but not the plane: best.split is to be set, too");

    EACH(nan_is_taken, sah_area(in.box) > 0 ? is_best(job, i, answers) : isnan(found.cost),
         "in a cell without area each cost is NaN, and is taken: only a lower cost may be");
    ONLY(many_lost, i == MANY_NODE,
         "only the node with the most spheres is wrong: a bin holds more of them than 16 bits "
         "count");

    ONLY(not_cheapest, kept_of(job, i, found) == RIGHT_COST,
         "the cost is that of the plane that is kept, but another plane is cheaper: it is not "
         "asked, or not kept");
    ONLY(miscounted, kept_of(job, i, found) != NO_PLANE,
         "the cost that is kept is not always that of the plane that is kept: in its children too "
         "many or too few spheres are counted, or it is another plane's");
    return NO_MORE;
}

// ---- Answers ------------------------------------------------------------------------------------

static Words words_plane(u32 axis, f32 pos)
{
    return axis < 3 ? words("%c = %s", "xyz"[axis], words_float(pos).text)
                    : words("axis %u, which is none", axis);
}

// What a plane of the student's costs, where it is a candidate and the cost is wrong.
static Words words_cost(const SahNode *node, BestAnswer found)
{
    const int number = found.axis < 3 ? sah_plane_number(node->box, found.axis, found.pos) : 0;
    if (number == 0) {
        return words(", but that is no candidate plane;");
    }
    const double cost = sah_weigh(node, found.axis, number).cost;
    return fabs(found.cost - cost) <= SAH_COST_TOLERANCE * cost
               ? words(",")
               : words(", but that plane costs %.6g;", cost);
}

static char *describe(const void *job, int i, const void *answers)
{
    GIVEN;
    const SahNode node = node_of(job, i);
    const SahPlane best = sah_best(&node);
    if (best.cost == INFINITY) {
        return message_new("cell %s with %u sphere%s, which has no area: found the cost %g, "
                           "expected INFINITY",
                           words_box3d(in.box).text, in.n_ids, plural(in.n_ids), found.cost);
    }
    return message_new("cell %s with %u sphere%s: found %s with cost %.6g%s expected %s with cost "
                       "%.6g",
                       words_box3d(in.box).text, in.n_ids, plural(in.n_ids),
                       words_plane(found.axis, found.pos).text, found.cost,
                       words_cost(&node, found).text, words_plane(best.axis, best.pos).text,
                       best.cost);
}

const Function best_08 = {"bests", N_BESTS, sizeof(BestAnswer), KNOWING(is_best, describe, known),
                          .counted = "cells"};

// Nobody has to call split_cost: the best plane by true costs is right, too. Where the cell has no
// area, the one says that there is none, and the other need not.
int bests_alone_08(const void *job, const JudgeCheck *check, const Sections *answers)
{
    const BestAnswer *found = function_answers(&best_08, answers);
    // In the place of whole trees: all inputs.
    const Range range = check->function != NULL ? check->range : (Range){0, N_BESTS, 1};
    int n_right = 0, n_following = 0;
    for (int k = 0; found != NULL && k < range.n; k++) {
        const int i = range_at(range, k);
        const int is_free = sah_area(((const Job08 *)job)->bests[i].box) == 0;
        n_right += is_free || follows(job, i, found[i], (Way){0});
        n_following += is_free || follows(job, i, found[i], (Way){.is_stub = 1});
    }
    return n_right == range.n || n_following == range.n;
}
