// Lab 08: split_cost and is_leaf_by_cost on their inputs. See judge_08.h; judge_08_area.c and
// judge_08_best.c are the siblings.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- split_cost ---------------------------------------------------------------------------------

// A known mistake, and what is said about it; number 0 is none.
typedef struct CostMistake {
    Cause cause;
    SahRules rules;
    u32 most_counted;  // with more spheres in a child than that anything, and all else is right
} CostMistake;

#define NO_BONUS                                                                                   \
    {.says = "that a child is empty makes a split no cheaper: the formula has no bonus for it"}

static const CostMistake cost_mistakes[] = {
    {.cause = {0}},
    {{.says = "that weighs by the lengths of edges: a ray in space meets a box by its surface"},
     .rules = {.measure = SAH_EDGES}},
    {{.says = "that weighs by volume: so a point meets a box, and not a ray"},
     .rules = {.measure = SAH_VOLUME}},
    {{.says = "both children count in full, as if every ray met both"},
     .rules = {.measure = SAH_SAME}},
    {{.says = "the step at the node itself is missing: KD_COST_TRAVERSAL"},
     .rules = {.no_traversal = 1}},
    {{.says = "a test costs KD_COST_TEST, not 1"}, .rules = {.no_test = 1}},
    {{.says = "the two constants stand in each other's place"}, .rules = {.constants_swapped = 1}},
    {{.says = "that is not divided by the area of the cell itself"}, .rules = {.no_division = 1}},
    {{.says = "each child's area goes with the other one's spheres"},
     .rules = {.counts_swapped = 1}},
    {{.says = "the two probabilities do not add up to 1: a ray may meet both children"},
     .rules = {.shares_of_sum = 1}},
    {{.says = "a ray that meets both children pays for both: nothing is taken off"},
     .rules = {.no_both = 1}},
    {{.says = "that is as if a ray met one child alone: the second probability is not 1 minus the "
              "first"},
     .rules = {.higher_is_rest = 1}},
    {NO_BONUS, .rules = {.bonus = 0.2}},
    {NO_BONUS, .rules = {.bonus = 0.5}},
    {NO_BONUS, .rules = {.bonus = 0.2, .bonus_of_tests = 1}},
    {NO_BONUS, .rules = {.bonus = 0.5, .bonus_of_tests = 1}},
    {{.says = "the step is paid where a child is empty, too"}, .rules = {.empty_saves_step = 1}},
    {{.says = "the step is paid where both children are empty, too"},
     .rules = {.none_saves_step = 1}},
    {{.says = "a child that the plane leaves flat still has a surface, and rays meet it"},
     .rules = {.flat_is_missed = 1}},
    {{.says = "the lower child's box is not cut at the plane"}, .rules = {.lower_uncut = 1}},
    {{.says = "the higher child's box is not cut at the plane"}, .rules = {.higher_uncut = 1}},
    {{.says = "the children are cut across x, whatever the split's axis is"},
     .rules = {.cut_across_x = 1}},
    {{.says = "a child without spheres costs no test"}, .rules = {.one_at_least = 1}},
    {{.says = "the expected number of tests was cut to a whole number"},
     .rules = {.whole_tests = 1}},
    {{.says = "KD_COST_TRAVERSAL is added: what is expected multiplies KD_COST_TEST alone"},
     .rules = {.all_multiplied = 1}},
    {{.says = "KD_COST_TEST multiplies the tests of both children, not of the lower one alone"},
     .rules = {.lower_tests = 1}},
    {{.says = "the higher child is missing"}, .rules = {.lower_only = 1}},
    {{.says = "the lower child is missing"}, .rules = {.higher_only = 1}},
    {{.says = "only splits of very many spheres are wrong: 32 bits with a sign do not hold their "
              "count"},
     .most_counted = INT32_MAX},
    {{.says = "only splits of many spheres are wrong: 16 bits do not hold their count"},
     .most_counted = UINT16_MAX},
};

// Is a number right up to rounding? NaN is not.
static int is_near(double found, double expected, double tolerance)
{
    return fabs(found - expected) <= tolerance * fabs(expected);
}

static int cost_agrees(const void *pointer, int i, const void *answers, int number)
{
    const CostJob split = ((const Job08 *)pointer)->costs[i];
    const CostMistake *mistake = &cost_mistakes[number];
    const u32 most = split.n_lower > split.n_higher ? split.n_lower : split.n_higher;
    return (mistake->most_counted > 0 && most > mistake->most_counted) ||
           is_near(((const double *)answers)[i], sah_cost(split, &mistake->rules),
                   SAH_COST_TOLERANCE);
}

static char *describe_cost(const void *pointer, int i, const void *answers)
{
    static const SahRules right = {0};
    const CostJob split = ((const Job08 *)pointer)->costs[i];
    return message_new("cell %s split at %c = %s, %u sphere%s below and %u above: found %.9g, "
                       "expected %.9g",
                       words_box3d(split.box).text, "xyz"[split.axis], words_float(split.pos).text,
                       split.n_lower, plural(split.n_lower), split.n_higher,
                       ((const double *)answers)[i], sah_cost(split, &right));
}

const Function cost_08 = {"costs", N_COSTS, sizeof(double),
                          COMPARED(cost_agrees, describe_cost, cost_mistakes), .counted = "splits"};

// Nobody has to call surface_area: costs by the true areas are right, too.
int costs_alone_08(const void *pointer, const JudgeCheck *check, const Sections *answers)
{
    const Job08 *job = pointer;
    const SahRules stand_in = {.measure = SAH_STAND_IN, .lot = job->job.lot};
    const double *found = function_answers(check->function, answers);
    if (found == NULL) {
        return 0;
    }
    int n_right = 0, n_following = 0;
    for (int i = 0; i < check->range.n; i++) {
        const int input = range_at(check->range, i);
        n_right += cost_agrees(job, input, found, 0);
        n_following +=
            is_near(found[input], sah_cost(job->costs[input], &stand_in), SAH_COST_TOLERANCE);
    }
    return n_right == check->range.n || n_following == check->range.n;
}

// ---- is_leaf_by_cost ----------------------------------------------------------------------------

// A way of deciding.
typedef struct LeafMistake {
    Cause cause;
    int one_level_more;  // level maxDepth is split, too
    int one_level_less;  // the level before it stays a leaf
    int fewer_than;      // targetElementsPerNode itself is split, too
    int equal_is_split;  // so is a node whose split costs as much as the leaf
    int no_depth;        // a limit is not looked at
    int no_target;
    int no_cost;
    int leaf_steps;  // a leaf costs KD_COST_TRAVERSAL, too
    int no_test;     // its tests cost 1
    int cuts_leaf;   // what it costs is cut to a whole number
    int cuts_split;  // so is what the split costs
    int is_signed;   // the number of spheres is an int
    int is_reversed;
    int both_limits;  // both limits must be reached
} LeafMistake;

#define COST_CUT {.says = "a cost was cut to a whole number: half a step makes a difference, too"}

static const LeafMistake leaf_mistakes[] = {
    {.cause = {0}},
    {{.says = "on level maxDepth itself a node stays a leaf"}, .one_level_more = 1},
    {{.says = "a node on the level before maxDepth may be split"}, .one_level_less = 1},
    {{.says = "with just targetElementsPerNode spheres it stays a leaf"}, .fewer_than = 1},
    {{.says = "a split that costs as much as the leaf gains nothing"}, .equal_is_split = 1},
    {{.says = "maxDepth is not looked at"}, .no_depth = 1},
    {{.says = "targetElementsPerNode is not looked at"}, .no_target = 1},
    {{.says = "the cost does not end the splitting by itself, as it should"}, .no_cost = 1},
    {{.says = "a leaf chooses no child: KD_COST_TRAVERSAL is in the split's cost alone, and stays "
              "there"},
     .leaf_steps = 1},
    {{.says = "a test costs KD_COST_TEST, not 1"}, .no_test = 1},
    {{.says = "the other way round: the cheaper of the two is right"}, .is_reversed = 1},
    {{.says = "each limit ends the splitting by itself, not only both together"}, .both_limits = 1},
    {COST_CUT, .cuts_leaf = 1},
    {COST_CUT, .cuts_split = 1},
    {COST_CUT, .cuts_leaf = 1, .cuts_split = 1},
    {{.says = "as an int the number of very many spheres is negative: the limit is to be unsigned, "
              "not the number signed"},
     .is_signed = 1},
};

static double cut_where(int is_cut, double cost)
{
    return is_cut ? trunc(cost) : cost;
}

static int expected_decision(LeafCostJob in, const LeafMistake *mistake)
{
    const double leaf_cost =
        cut_where(mistake->cuts_leaf, (mistake->no_test ? 1 : SAH_TEST) * in.n_spheres +
                                          (mistake->leaf_steps ? SAH_TRAVERSAL : 0));
    const double cost = cut_where(mistake->cuts_split, in.best_cost);
    const int64_t n_spheres = mistake->is_signed ? (i32)in.n_spheres : (int64_t)in.n_spheres;
    const int is_deep = !mistake->no_depth &&
                        in.level >= in.maxDepth + mistake->one_level_more - mistake->one_level_less;
    const int is_small =
        !mistake->no_target && n_spheres <= in.targetElementsPerNode - mistake->fewer_than;
    const int is_dear = mistake->no_cost          ? 0
                        : mistake->is_reversed    ? cost < leaf_cost
                        : mistake->equal_is_split ? cost > leaf_cost
                                                  : cost >= leaf_cost;
    return (mistake->both_limits ? is_deep && is_small : is_deep || is_small) || is_dear;
}

static int decision_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const LeafCostJob in = ((const Job08 *)pointer)->decisions[i];
    // What INFINITY is as a whole number, C leaves open.
    return (leaf_mistakes[mistake].cuts_split && isinf(in.best_cost)) ||
           (((const i32 *)answers)[i] != 0) == expected_decision(in, &leaf_mistakes[mistake]);
}

// A mistake explains all inputs, not only those of the check: one limit is often forgotten as the
// other one is.
static int decision_shows(const void *job, Range range, const void *answers, int mistake)
{
    int i = 0;
    (void)range;
    while (i < N_DECISIONS && decision_agrees(job, i, answers, mistake)) {
        i++;
    }
    return i == N_DECISIONS;
}

static char *describe_decision(const void *pointer, int i, const void *answers)
{
    const LeafCostJob in = ((const Job08 *)pointer)->decisions[i];
    return message_new("level %d of at most %d, %u sphere%s where %d make a leaf, a leaf costs %g "
                       "and the best split %g: found %d, expected %d",
                       in.level, in.maxDepth, in.n_spheres, plural(in.n_spheres),
                       in.targetElementsPerNode, SAH_TEST * in.n_spheres, in.best_cost,
                       ((const i32 *)answers)[i], expected_decision(in, &leaf_mistakes[0]));
}

const Function decision_08 = {"decisions",
                              N_DECISIONS,
                              sizeof(i32),
                              COMPARED(decision_agrees, describe_decision, leaf_mistakes),
                              .shows = decision_shows,
                              .counted = "nodes"};
