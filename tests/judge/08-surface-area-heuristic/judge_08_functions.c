// Lab 08: surface_area, split_cost and is_leaf_by_cost on their inputs. See judge_08.h;
// judge_08_best.c is the sibling.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

// A known mistake, and what is said about it; number 0 is none.
typedef struct SahMistake {
    Cause cause;
    SahRules rules;
} SahMistake;

// ---- surface_area -------------------------------------------------------------------------------

static const SahMistake area_mistakes[] = {
    {.cause = {0}},
    {{.says = "that is half of the faces: each has its like on the other side"},
     {.measure = SAH_HALF_AREA}},
    {{.says = "that is the length of the twelve edges"}, {.measure = SAH_EDGES}},
    {{.says = "that is the sum of the three lengths"}, {.measure = SAH_SIDES}},
    {{.says = "that is the volume"}, {.measure = SAH_VOLUME}},
    {{.says = "the two faces at right angles to x are missing"}, {.measure = SAH_WITHOUT_X}},
    {{.says = "the two faces at right angles to y are missing"}, {.measure = SAH_WITHOUT_Y}},
    {{.says = "the two faces at right angles to z are missing"}, {.measure = SAH_WITHOUT_Z}},
};

// Is a number right up to rounding? NaN is not.
static int is_near(double found, double expected, double tolerance)
{
    return fabs(found - expected) <= tolerance * fabs(expected);
}

static int area_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const BBox3D box = ((const Job08 *)pointer)->areas[i];
    return is_near(((const double *)answers)[i],
                   sah_size(box, area_mistakes[mistake].rules.measure), SAH_AREA_TOLERANCE);
}

static char *describe_area(const void *pointer, int i, const void *answers)
{
    const BBox3D box = ((const Job08 *)pointer)->areas[i];
    return message_new("box %s: found %.9g, expected %.9g", words_box3d(box).text,
                       ((const double *)answers)[i], sah_size(box, SAH_AREA));
}

const Function area_08 = {"areas",
                          N_AREAS,
                          sizeof(double),
                          .agrees = area_agrees,
                          .describe = describe_area,
                          .counted = "boxes",
                          MISTAKES(area_mistakes)};

// ---- split_cost ---------------------------------------------------------------------------------

static const SahMistake cost_mistakes[] = {
    {.cause = {0}},
    {{.says = "that weighs by the lengths of edges: a ray in space meets a box by its surface"},
     {.measure = SAH_EDGES}},
    {{.says = "that weighs by volume: so a point meets a box, and not a ray"},
     {.measure = SAH_VOLUME}},
    {{.says = "both children count in full, as if every ray met both"}, {.measure = SAH_SAME}},
    {{.says = "the step at the node itself is missing: KD_COST_TRAVERSAL"}, {.no_traversal = 1}},
    {{.says = "a test costs KD_COST_TEST, not 1"}, {.no_test = 1}},
    {{.says = "the two constants stand in each other's place"}, {.constants_swapped = 1}},
    {{.says = "that is not divided by the area of the cell itself"}, {.no_division = 1}},
    {{.says = "each child's area goes with the other one's spheres"}, {.counts_swapped = 1}},
    {{.says = "the two probabilities do not add up to 1: a ray may meet both children"},
     {.shares_of_sum = 1}},
    {{.says = "a ray that meets both children pays for both: nothing is taken off"},
     {.no_both = 1}},
    {{.says = "KD_COST_TRAVERSAL is added: what is expected multiplies KD_COST_TEST alone"},
     {.all_multiplied = 1}},
    {{.says = "KD_COST_TEST multiplies the tests of both children, not of the lower one alone"},
     {.lower_tests = 1}},
    {{.says = "the higher child is missing"}, {.lower_only = 1}},
    {{.says = "the lower child is missing"}, {.higher_only = 1}},
};

static int cost_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const CostJob split = ((const Job08 *)pointer)->costs[i];
    return is_near(((const double *)answers)[i], sah_cost(split, &cost_mistakes[mistake].rules),
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

const Function cost_08 = {"costs",
                          N_COSTS,
                          sizeof(double),
                          .agrees = cost_agrees,
                          .describe = describe_cost,
                          .counted = "splits",
                          MISTAKES(cost_mistakes)};

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
    int fewer_than;      // targetElementsPerNode itself is split, too
    int equal_is_split;  // so is a node whose split costs as much as the leaf
    int no_depth;        // a limit is not looked at
    int no_target;
    int no_cost;
    int leaf_steps;  // a leaf costs KD_COST_TRAVERSAL, too
    int no_test;     // its tests cost 1
    int is_reversed;
    int both_limits;  // both limits must be reached
} LeafMistake;

static const LeafMistake leaf_mistakes[] = {
    {.cause = {0}},
    {{.says = "on level maxDepth itself a node stays a leaf"}, .one_level_more = 1},
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
};

static int expected_decision(LeafCostJob in, const LeafMistake *mistake)
{
    const double leaf_cost = (mistake->no_test ? 1 : SAH_TEST) * in.n_spheres +
                             (mistake->leaf_steps ? SAH_TRAVERSAL : 0);
    const double cost = in.best_cost;
    const int is_deep = !mistake->no_depth && in.level >= in.maxDepth + mistake->one_level_more;
    const int is_small = !mistake->no_target &&
                         (int64_t)in.n_spheres <= in.targetElementsPerNode - mistake->fewer_than;
    const int is_dear = mistake->no_cost          ? 0
                        : mistake->is_reversed    ? cost < leaf_cost
                        : mistake->equal_is_split ? cost > leaf_cost
                                                  : cost >= leaf_cost;
    return (mistake->both_limits ? is_deep && is_small : is_deep || is_small) || is_dear;
}

static int decision_agrees(const void *pointer, int i, const void *answers, int mistake)
{
    const LeafCostJob in = ((const Job08 *)pointer)->decisions[i];
    return (((const i32 *)answers)[i] != 0) == expected_decision(in, &leaf_mistakes[mistake]);
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
                              .agrees = decision_agrees,
                              .describe = describe_decision,
                              .counted = "nodes",
                              MISTAKES(leaf_mistakes)};

// In the place of whole trees: all inputs.
int decisions_alone_08(const void *job, const JudgeCheck *check, const Sections *answers)
{
    (void)check;
    return verdict_passes(function_judge(&decision_08, job, (Range){0, N_DECISIONS, 1}, answers));
}
