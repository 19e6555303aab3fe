// Lab 08: find_best_split on its inputs, by asking every sphere at every plane. See judge_08.h.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

// A known mistake, and what is said about it; number 0 is none.
typedef struct BestMistake {
    Cause cause;
    SahRules rules;
    int is_lost_many;  // of the node with the most spheres anything, and all else is right
} BestMistake;

#define EPSILON {.says = "a plane that is cheaper by however little is the better one: no epsilon"}

#define BY_CENTRE {.says = "a sphere counts by its range, not by its centre"}

static const BestMistake best_mistakes[] = {
    {.cause = {0}},
    {{.says = "of equal costs the first plane counts: x before y before z, and the lower one first",
      .mistake = MISTAKE_LATER_OF_EQUALS},
     .rules = {.last_of_equals = 1}},
    {{.says = "only the longest side is searched, not all three"}, .rules = {.longest_only = 1}},
    {{.says = "planes across z are not searched"}, .rules = {.no_z = 1}},
    {{.says = "planes across y are not searched"}, .rules = {.no_y = 1}},
    {{.says = "only planes across x are searched"}, .rules = {.no_y = 1, .no_z = 1}},
    {{.says = "that is the plane with the highest cost"}, .rules = {.highest_cost = 1}},
    {BY_CENTRE, .rules = {.by_centre = 1}},
    {BY_CENTRE, .rules = {.by_centre = 1, .end_below = 1}},
    {BY_CENTRE, .rules = {.by_centre = 1, .begin_above = 1}},
    {{.says = "a range that begins at the plane counts in the lower child, too",
      .mistake = MISTAKE_STRICT_BOUNDARY},
     .rules = {.begin_above = 1}},
    {{.says = "a range that ends at the plane counts in the higher child, too",
      .mistake = MISTAKE_STRICT_BOUNDARY},
     .rules = {.end_below = 1}},
    {{.says = "a range that only touches the plane counts in both children",
      .mistake = MISTAKE_STRICT_BOUNDARY},
     .rules = {.begin_above = 1, .end_below = 1}},
    {{.says = "a negative radius counts as its absolute value"}, .rules = {.signed_radius = 1}},
    {{.says = "the first plane is not asked"}, .rules = {.without_first = 1}},
    {{.says = "the last plane is not asked"}, .rules = {.without_last = 1}},
    {{.says = "the border of the cell is asked, too: only planes within the cell are candidates"},
     .rules = {.to_border = 1}},
    {{.says = "the border of the cell is asked, too: only planes within the cell are candidates"},
     .rules = {.from_border = 1}},
    {{.says = "the border of the cell is asked, too: only planes within the cell are candidates"},
     .rules = {.from_border = 1, .to_border = 1}},
    {{.says = "of equal costs on several axes x counts before y, and y before z"},
     .rules = {.later_axis = 1}},
    {{.says = "of equal costs on an axis the lower plane counts"}, .rules = {.later_plane = 1}},
    {{.says = "behind a plane that costs more than the one before a cheaper one may come: all are "
              "asked"},
     .rules = {.stops_rising = 1}},
    {{.says = "a plane that leaves a child empty is a candidate, too"}, .rules = {.no_empty = 1}},
    {{.says = "the cheapest plane is searched, also where a leaf is cheaper: that is asked later"},
     .rules = {.below_leaf = 1}},
    {{.says = "a sphere that begins before the cell is in its lower child, too"},
     .rules = {.begin_in_cell = 1}},
    {{.says = "a sphere that ends in the bin before a plane is not in its higher child any more"},
     .rules = {.ends_late = 1}},
    {{.says = "the ends are off by one bin: who ends in the bin behind a plane is in its higher "
              "child still"},
     .rules = {.ends_early = 1}},
    {{.says = "the begins are off by one bin: who begins in the bin before a plane is in its lower "
              "child"},
     .rules = {.begins_late = 1}},
    {{.says = "the begins are off by one bin: who begins in the bin behind a plane is not yet in "
              "its lower child"},
     .rules = {.begins_early = 1}},
    {{.says = "all bins are off by one: at a plane only those before it are counted, up to bin "
              "plane - 1"},
     .rules = {.begins_early = 1, .ends_early = 1}},
    {{.says = "all bins are off by one: at a plane the bin just before it, plane - 1, is counted, "
              "too"},
     .rules = {.begins_late = 1, .ends_late = 1}},
    {{.says = "the higher child keeps all spheres: those that end before the plane leave it"},
     .rules = {.higher_keeps = 1}},
    {{.says = "the bins of an axis begin with what those of the axis before hold, not with 0"},
     .rules = {.carried_over = 1}},
    {{.says = "the cheapest of all three axes counts, not of the last one"},
     .rules = {.last_axis = 1}},
    {{.says = "a sphere over the plane is in both children: the higher one has more than the rest"},
     .rules = {.rest_is_higher = 1}},
    {{.says = "the node's spheres are those that its ids name"}, .rules = {.all_spheres_id = 1}},
    {EPSILON, .rules = {.least_gain = 1e-2}},
    {EPSILON, .rules = {.least_gain = 1e-3}},
    {EPSILON, .rules = {.least_gain = 1e-4}},
    {EPSILON, .rules = {.least_gain = 1e-5}},
    {EPSILON, .rules = {.least_share = 1e-2}},
    {EPSILON, .rules = {.least_share = 1e-3}},
    {EPSILON, .rules = {.least_share = 1e-4}},
    {{.says = "in a cell without area each cost is NaN, and is taken: only a lower cost may be"},
     .rules = {.nan_is_taken = 1}},
    {{.says = "only the node with the most spheres is wrong: a bin holds more of them than 16 bits "
              "count"},
     .is_lost_many = 1},
};

// The input number i as a node.
static SahNode node_of(const Job08 *job, int i)
{
    const BestJob in = job->bests[i];
    return (SahNode){in.box, job->best_spheres, job->best_ids + in.first_id, NULL, in.n_ids};
}

// Of exact ties only the first is right; elsewhere the costs of two planes may be so near that
// float takes one for the other.
static int is_tie(int i)
{
    return i >= N_CELLS && i < N_CELLS + N_TIES;
}

// Is this an answer that follows from the rules?
static int follows(const Job08 *job, int i, BestAnswer found, const SahRules *rules)
{
    const SahNode node = node_of(job, i);
    const SahPlane best = sah_best(&node, rules);
    if (best.cost == INFINITY) {
        return rules->nan_is_taken ? isnan(found.cost) : found.cost == INFINITY;
    }
    const int number = found.axis < 3 ? sah_plane_number(node.box, found.axis, found.pos) : 0;
    const int is_best = found.axis == best.axis && found.pos == best.pos;
    if (!(fabs(found.cost - best.cost) <= SAH_COST_TOLERANCE * best.cost)) {
        return 0;
    }
    if (is_tie(i) || rules->last_of_equals || number == 0) {
        return is_best;
    }
    const double cost = sah_weigh(&node, found.axis, number, rules).cost;
    return cost <= best.cost * (1 + 2 * SAH_COST_TOLERANCE) || rules->highest_cost;
}

static int best_agrees(const void *job, int i, const void *answers, int mistake)
{
    return (best_mistakes[mistake].is_lost_many && i == MANY_NODE) ||
           follows(job, i, ((const BestAnswer *)answers)[i], &best_mistakes[mistake].rules);
}

// A mistake explains all inputs, not only those of the check: where costs are equal by design, many
// choose the same plane.
static int best_shows(const void *job, Range range, const void *answers, int mistake)
{
    int i = 0;
    (void)range;
    while (i < N_BESTS && best_agrees(job, i, answers, mistake)) {
        i++;
    }
    return i == N_BESTS;
}

static Words words_plane(u32 axis, f32 pos)
{
    return axis < 3 ? words("%c = %s", "xyz"[axis], words_float(pos).text)
                    : words("axis %u, which is none", axis);
}

// What a plane of the student's costs, where it is a candidate and the cost is wrong.
static Words words_cost(const SahNode *node, BestAnswer found)
{
    static const SahRules right = {0};
    const int number = found.axis < 3 ? sah_plane_number(node->box, found.axis, found.pos) : 0;
    if (number == 0) {
        return words(", but that is no candidate plane;");
    }
    const double cost = sah_weigh(node, found.axis, number, &right).cost;
    return fabs(found.cost - cost) <= SAH_COST_TOLERANCE * cost
               ? words(",")
               : words(", but that plane costs %.6g;", cost);
}

static char *describe_best(const void *pointer, int i, const void *answers)
{
    static const SahRules right = {0};
    const SahNode node = node_of(pointer, i);
    const BestAnswer found = ((const BestAnswer *)answers)[i];
    const SahPlane best = sah_best(&node, &right);
    if (best.cost == INFINITY) {
        return message_new("cell %s with %u sphere%s, which has no area: found the cost %g, "
                           "expected INFINITY",
                           words_box3d(node.box).text, node.n_ids, plural(node.n_ids), found.cost);
    }
    return message_new("cell %s with %u sphere%s: found %s with cost %.6g%s expected %s with cost "
                       "%.6g",
                       words_box3d(node.box).text, node.n_ids, plural(node.n_ids),
                       words_plane(found.axis, found.pos).text, found.cost,
                       words_cost(&node, found).text, words_plane(best.axis, best.pos).text,
                       best.cost);
}

const Function best_08 = {"bests",
                          N_BESTS,
                          sizeof(BestAnswer),
                          COMPARED(best_agrees, describe_best, best_mistakes),
                          .shows = best_shows,
                          .counted = "cells"};

// Nobody has to call split_cost: the best plane by true costs is right, too. Where the cell has no
// area, the one says that there is none, and the other need not.
static int stands_alone(const Job08 *job, Range range, const BestAnswer *found)
{
    static const SahRules right = {0};
    const SahRules stand_in = {.is_stand_in = 1, .lot = job->job.lot};
    int n_right = 0, n_following = 0;
    for (int i = 0; i < range.n; i++) {
        const int input = range_at(range, i);
        const int is_free = sah_size(job->bests[input].box, SAH_AREA) == 0;
        n_right += is_free || follows(job, input, found[input], &right);
        n_following += is_free || follows(job, input, found[input], &stand_in);
    }
    return n_right == range.n || n_following == range.n;
}

int bests_alone_08(const void *job, const JudgeCheck *check, const Sections *answers)
{
    const BestAnswer *found = function_answers(&best_08, answers);
    // In the place of whole trees: all inputs.
    const Range range = check->function != NULL ? check->range : (Range){0, N_BESTS, 1};
    return found != NULL && stands_alone(job, range, found);
}
