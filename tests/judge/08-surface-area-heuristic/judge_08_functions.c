// Lab 08: split_cost and is_leaf_by_cost on their inputs. See judge_08.h; judge_08_area.c and
// judge_08_best.c are the siblings.
#include "judge_08.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- split_cost: right --------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const CostJob in = ((const Job08 *)job)->costs[i];                                             \
    const double found = ((const double *)answers)[i]
// NaN is not near to anything.
#define IS_FOUND(cost) (fabs(found - (cost)) <= SAH_COST_TOLERANCE * fabs(cost))

static double stand_in_area(BBox3D box, u32 LOT)
{
#include "08-surface-area-heuristic/surface_area.c"
}

// A cell's area as surface_area has it, or its stand-in.
static double area_of(const Job *job, BBox3D box)
{
    return job->is_alone ? stand_in_area(box, job->lot) : sah_area(box);
}

// The areas of the lower child, of the higher one, and of the cell; and their spheres.
#define L area_of(job, sah_lower(in))
#define H area_of(job, sah_higher(in))
#define A area_of(job, in.box)
#define N_L ((double)in.n_lower)
#define N_H ((double)in.n_higher)
#define TESTS ((L * N_L + H * N_H) / A)

static double with_tests(double n_expected)
{
    return SAH_TRAVERSAL + SAH_TEST * n_expected;
}

static double cost_of(const Job *job, CostJob in)
{
    return job->is_alone ? with_tests(TESTS) : sah_cost(in);
}

#define COST cost_of(job, in)

RIGHT(is_cost, IS_FOUND(COST))

// ---- split_cost: mistakes -----------------------------------------------------------------------

// The expected number of tests, with another measure than the area.
static double tests_by(double (*size)(BBox3D box), CostJob in)
{
    return (size(sah_lower(in)) * N_L + size(sah_higher(in)) * N_H) / size(in.box);
}

#define SIDE(axis) ((double)box.max[axis] - (double)box.min[axis])

#define ONE_DIVIDED "the area of each child is divided by the cell's, not that of one alone"

static double edges(BBox3D box)
{
    return SIDE(0) + SIDE(1) + SIDE(2);
}

static double volume(BBox3D box)
{
    return SIDE(0) * SIDE(1) * SIDE(2);
}

static CostJob across_x(CostJob in)
{
    in.axis = 0;
    return in;
}

// With an empty child all of it is cheaper, or the tests are.
static double with_bonus(const Job *job, CostJob in, double of_step, double of_tests)
{
    return in.n_lower == 0 || in.n_higher == 0
               ? of_step * SAH_TRAVERSAL + of_tests * SAH_TEST * TESTS
               : COST;
}

// Of the fraction each part is another: an area, a number of spheres; their difference.
static double fraction_of(const Job *job, CostJob in, int way)
{
    const double areas[] = {L, H, A}, counts[] = {N_L, N_H, N_L + N_H},
                 divisors[] = {A, L + H, 1, L, H};
    const double lower = areas[way % 3] * counts[way / 3 % 3],
                 higher = areas[way / 9 % 3] * counts[way / 27 % 3];
    return (way / 81 % 2 ? lower - higher : lower + higher) / divisors[way / 162];
}

// All with more spheres in a child than that are wrong, and no others.
#define IS_LOST_ABOVE(count)                                                                       \
    ((in.n_lower > (count) || in.n_higher > (count)) != is_cost(job, i, answers))

KNOWN_LIST(cost_known)
{
    GIVEN;

    ANSWERS(by_edges, with_tests(tests_by(edges, in)),
            "that weighs by the lengths of edges: a ray in space meets a box by its surface");
    // Of a flat cell comes 0 / 0.
    EACH(by_volume, volume(in.box) == 0 || IS_FOUND(with_tests(tests_by(volume, in))),
         "that weighs by volume: so a point meets a box, and not a ray");
    ANSWERS(both_in_full, with_tests(N_L + N_H),
            "both children count in full, as if every ray met both");
    ANSWERS(no_traversal, (SAH_TEST * TESTS),
            "the step at the node itself is missing: KD_COST_TRAVERSAL");
    ANSWERS(no_test, SAH_TRAVERSAL + TESTS, "a test costs KD_COST_TEST, not 1");
    ANSWERS(constants_swapped, SAH_TEST + SAH_TRAVERSAL * TESTS,
            "the two constants stand in each other's place");
    ANSWERS(no_division, with_tests((TESTS * A)),
            "that is not divided by the area of the cell itself");
    ANSWERS(counts_swapped, with_tests((L * N_H + H * N_L) / A),
            "each child's area goes with the other one's spheres");
    ANSWERS(shares_of_sum, with_tests((L * N_L + H * N_H) / (L + H)),
            "the two probabilities do not add up to 1: a ray may meet both children");
    ANSWERS(no_both, with_tests(((A - H) * N_L + H * N_H) / A),
            "a ray that meets both children pays for both: nothing is taken off");
    ANSWERS(
        higher_is_rest, with_tests((L * N_L + (A - L) * N_H) / A),
        "that is as if a ray met one child alone: the second probability is not 1 minus the first");
    ANSWERS(lower_uncut, with_tests((A * N_L + H * N_H) / A),
            "the lower child's box is not cut at the plane");
    ANSWERS(higher_uncut, with_tests((L * N_L + A * N_H) / A),
            "the higher child's box is not cut at the plane");
    ANSWERS(cut_across_x, cost_of(job, across_x(in)),
            "the children are cut across x, whatever the split's axis is");
    ANSWERS(one_at_least, with_tests((L * fmax(N_L, 1) + H * fmax(N_H, 1)) / A),
            "a child without spheres costs no test");
    ANSWERS(whole_tests, with_tests(trunc(TESTS)),
            "the expected number of tests was cut to a whole number");
    ANSWERS(all_multiplied, (SAH_TRAVERSAL + SAH_TEST) * TESTS,
            "KD_COST_TRAVERSAL is added: what is expected multiplies KD_COST_TEST alone");
    ANSWERS(lower_tests, SAH_TRAVERSAL + (SAH_TEST * L * N_L + H * N_H) / A,
            "KD_COST_TEST multiplies the tests of both children, not of the lower one alone");
    ANSWERS(lower_only, with_tests((L * N_L) / A), "the higher child is missing");
    ANSWERS(higher_only, with_tests((H * N_H) / A), "the lower child is missing");
    ANSWERS(both_lower, with_tests(L * (N_L + N_H) / A),
            "both children's boxes are cut on the same side: one keeps the cell's minimum, the "
            "other its maximum");
    ANSWERS(both_higher, with_tests(H * (N_L + N_H) / A),
            "both children's boxes are cut on the same side: one keeps the cell's minimum, the "
            "other its maximum");
    ANSWERS(all_in_both, with_tests((L + H) * (N_L + N_H) / A),
            "each child counts its own spheres only, not those of both");
    ANSWERS(lower_undivided, with_tests(L * N_L + H * N_H / A), ONE_DIVIDED);
    ANSWERS(higher_undivided, with_tests(L * N_L / A + H * N_H), ONE_DIVIDED);
    ANSWERS(mean, with_tests(TESTS / 2),
            "the two parts add up: a sum of expected tests is no mean");
    ANSWERS(two_steps, SAH_TRAVERSAL + with_tests(TESTS),
            "KD_COST_TRAVERSAL is paid once for a split, not for each child");
    ANSWERS(all_divided, with_tests(TESTS) - SAH_TRAVERSAL + SAH_TRAVERSAL / A,
            "the step is paid in full: only the areas are divided by the cell's");
    ANSWERS(flat_is_missed,
            with_tests(((in.pos > in.box.min[in.axis]) * L * N_L +
                        (in.pos < in.box.max[in.axis]) * H * N_H) /
                       A),
            "a child that the plane leaves flat still has a surface, and rays meet it");

    EACH(bonus,
         IS_FOUND(with_bonus(job, in, 0.8, 0.8)) || IS_FOUND(with_bonus(job, in, 0.5, 0.5)) ||
             IS_FOUND(with_bonus(job, in, 1, 0.8)) || IS_FOUND(with_bonus(job, in, 1, 0.5)),
         "that a child is empty makes a split no cheaper: the formula has no bonus for it");
    ANSWERS(empty_saves_step, with_bonus(job, in, 0, 1),
            "the step is paid where a child is empty, too");
    ANSWERS(none_saves_step, N_L + N_H == 0 ? 0 : COST,
            "the step is paid where both children are empty, too");

    ANSWERS(empty_is_missed, N_L == 0 || N_H == 0 ? with_tests(N_L + N_H) : COST,
            "with one child empty all spheres of the other were counted in full: a ray meets it "
            "only with the probability area over area, too");
    ANSWERS(mean_area, with_tests((L + H) / 2 * (N_L + N_H) / A),
            "each child's area goes with its own spheres, not a mean area with all of them");
    ANSWERS(taken_off, SAH_TRAVERSAL - SAH_TEST * TESTS, "the step and the tests add up");
    ANSWERS(multiplied_by_cell, with_tests(TESTS * A * A),
            "that is multiplied by the area of the cell, and is to be divided by it");

    ANY(other_fraction, 810, IS_FOUND(with_tests(fraction_of(job, in, way))),
        "each child's area times its own spheres, both added and divided by the cell's area: one "
        "of these parts is another");
    EACH(lost_signed, IS_LOST_ABOVE(INT32_MAX),
         "only splits of very many spheres are wrong: 32 bits with a sign do not hold their count");
    EACH(lost_short, IS_LOST_ABOVE(UINT16_MAX),
         "only splits of many spheres are wrong: 16 bits do not hold their count");
    return NO_MORE;
}

// ---- split_cost: answers ------------------------------------------------------------------------

static char *describe_cost(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("cell %s split at %c = %s, %u sphere%s below and %u above: found %.9g, "
                       "expected %.9g",
                       words_box3d(in.box).text, "xyz"[in.axis], words_float(in.pos).text,
                       in.n_lower, plural(in.n_lower), in.n_higher, found, sah_cost(in));
}

const Function cost_08 = {"costs", N_COSTS, sizeof(double),
                          KNOWING(is_cost, describe_cost, cost_known), .counted = "splits"};

// Nobody has to call surface_area: costs by the true areas are right, too.
int costs_alone_08(const void *pointer, const JudgeCheck *check, const Sections *answers_section)
{
    const Job08 *whole = pointer;
    const Job alone = {.lot = whole->job.lot, .is_alone = 1};
    const double *answers = function_answers(check->function, answers_section);
    int n_right = 0, n_following = 0;
    for (int k = 0; answers != NULL && k < check->range.n; k++) {
        const int i = range_at(check->range, k);
        const CostJob in = whole->costs[i];
        const double found = answers[i];
        n_right += IS_FOUND(sah_cost(in));
        n_following += IS_FOUND(cost_of(&alone, in));
    }
    return n_right == check->range.n || n_following == check->range.n;
}
#undef GIVEN
#undef IS_FOUND

// ---- is_leaf_by_cost: right ---------------------------------------------------------------------

#define GIVEN                                                                                      \
    const LeafCostJob in = ((const Job08 *)job)->decisions[i];                                     \
    const i32 found = ((const i32 *)answers)[i]
#define IS_FOUND(expected) ((found != 0) == (expected))

#define EACH_ENOUGH "each of the three reasons is enough by itself: joined by or, not by and"
#define LEAF_COST (SAH_TEST * in.n_spheres)
#define IS_DEEP (in.level >= in.maxDepth)
#define IS_SMALL ((int64_t)in.n_spheres <= in.targetElementsPerNode)
#define IS_DEAR (in.best_cost >= LEAF_COST)
#define IS_LEAF (IS_DEEP || IS_SMALL || IS_DEAR)

RIGHT(is_decision, IS_FOUND(IS_LEAF))

// ---- is_leaf_by_cost: mistakes ------------------------------------------------------------------

// One of the comparisons is another; or a leaf's cost is.
static int compares(double a, double b, int way)
{
    const int holds[] = {a<b, a <= b, a> b, a >= b, a == b, a != b};
    return holds[way];
}

#define TARGET ((double)in.targetElementsPerNode)

static double other_leaf_cost(LeafCostJob in, int way)
{
    const double n = in.n_spheres;
    const double costs[] = {SAH_TRAVERSAL * n,
                            SAH_TRAVERSAL + SAH_TEST,
                            SAH_TEST + n,
                            SAH_TEST,
                            (SAH_TRAVERSAL + SAH_TEST) * n,
                            SAH_TEST * TARGET,
                            SAH_TEST * in.level,
                            SAH_TEST / n};
    return costs[way];
}

KNOWN_LIST(leaf_known)
{
    GIVEN;

    ANSWERS(level_more, in.level > in.maxDepth || IS_SMALL || IS_DEAR,
            "on level maxDepth itself a node stays a leaf");
    ANSWERS(level_less, in.level + 1 >= in.maxDepth || IS_SMALL || IS_DEAR,
            "a node on the level before maxDepth may be split");
    ANSWERS(fewer, IS_DEEP || (int64_t)in.n_spheres < in.targetElementsPerNode || IS_DEAR,
            "with just targetElementsPerNode spheres it stays a leaf");
    ANSWERS(equal_is_split, IS_DEEP || IS_SMALL || in.best_cost > LEAF_COST,
            "a split that costs as much as the leaf gains nothing");
    ANSWERS(no_depth, IS_SMALL || IS_DEAR, "maxDepth is not looked at");
    ANSWERS(no_target, IS_DEEP || IS_DEAR, "targetElementsPerNode is not looked at");
    ANSWERS(no_cost, IS_DEEP || IS_SMALL,
            "the cost does not end the splitting by itself, as it should");
    ANSWERS(
        leaf_steps, IS_DEEP || IS_SMALL || in.best_cost >= LEAF_COST + SAH_TRAVERSAL,
        "a leaf chooses no child: KD_COST_TRAVERSAL is in the split's cost alone, and stays there");
    ANSWERS(tests_cost_1, IS_DEEP || IS_SMALL || in.best_cost >= in.n_spheres,
            "a test costs KD_COST_TEST, not 1");
    ANSWERS(reversed, IS_DEEP || IS_SMALL || in.best_cost < LEAF_COST,
            "the other way round: the cheaper of the two is right");
    ANSWERS(both_limits, (IS_DEEP && IS_SMALL) || IS_DEAR,
            "each limit ends the splitting by itself, not only both together");
    ANSWERS(is_signed, IS_DEEP || (i32)in.n_spheres <= in.targetElementsPerNode || IS_DEAR,
            "as an int the number of very many spheres is negative: the limit is to be unsigned, "
            "not the number signed");

    ANSWERS(level_equal, in.level == in.maxDepth || IS_SMALL || IS_DEAR,
            "a level may also be beyond maxDepth: it is a limit, not one number");
    ANSWERS(target_equal, IS_DEEP || (int64_t)in.n_spheres == in.targetElementsPerNode || IS_DEAR,
            "there may also be fewer spheres than targetElementsPerNode: it is a limit, not one "
            "number");
    ANSWERS(both_strict,
            in.level > in.maxDepth || (int64_t)in.n_spheres < in.targetElementsPerNode || IS_DEAR,
            "on level maxDepth itself, and with just targetElementsPerNode spheres, a node stays a "
            "leaf");
    ANSWERS(split_steps, IS_DEEP || IS_SMALL || in.best_cost + SAH_TRAVERSAL >= LEAF_COST,
            "KD_COST_TRAVERSAL is in best_cost already: it counts once");
    ANSWERS(all_must, IS_DEEP && IS_SMALL && IS_DEAR, EACH_ENOUGH);
    ANSWERS(limit_and_cost, (IS_DEEP || IS_SMALL) && IS_DEAR, EACH_ENOUGH);
    ANSWERS(small_and_dear, IS_DEEP || (IS_SMALL && IS_DEAR), EACH_ENOUGH);
    ANSWERS(deep_and_dear, (IS_DEEP && IS_DEAR) || IS_SMALL, EACH_ENOUGH);
    ANSWERS(inverted, !IS_LEAF, "1 and 0 are swapped: 1 for a leaf");
    ANSWERS(limits_swapped,
            in.level >= in.targetElementsPerNode || (int64_t)in.n_spheres <= in.maxDepth || IS_DEAR,
            "the two limits are swapped: maxDepth is one of levels");
#define COST_CUT "a cost was cut to a whole number: half a step makes a difference, too"
    ANSWERS(leaf_cut, IS_DEEP || IS_SMALL || in.best_cost >= trunc(LEAF_COST), COST_CUT);
    // What INFINITY is as a whole number, C leaves open.
    EACH(split_cut,
         isinf(in.best_cost) || IS_FOUND(IS_DEEP || IS_SMALL || trunc(in.best_cost) >= LEAF_COST),
         COST_CUT);
    EACH(both_cut,
         isinf(in.best_cost) ||
             IS_FOUND(IS_DEEP || IS_SMALL || trunc(in.best_cost) >= trunc(LEAF_COST)),
         COST_CUT);
    ANY(other_depth, 6, IS_FOUND(compares(in.level, in.maxDepth, way) || IS_SMALL || IS_DEAR),
        "the level is compared with maxDepth in another way: from maxDepth on a node is a leaf");
    ANY(other_target, 6, IS_FOUND(IS_DEEP || compares(in.n_spheres, TARGET, way) || IS_DEAR),
        "the spheres are compared with targetElementsPerNode in another way: up to so many are a "
        "leaf");
    ANY(other_cost, 6, IS_FOUND(IS_DEEP || IS_SMALL || compares(in.best_cost, LEAF_COST, way)),
        "the costs are compared in another way: where a split is not cheaper than the leaf, it is "
        "one");

    ANY(other_leaf, 8, IS_FOUND(IS_DEEP || IS_SMALL || in.best_cost >= other_leaf_cost(in, way)),
        "a leaf costs KD_COST_TEST for each of its spheres: the split is compared with something "
        "else");
    return NO_MORE;
}

// ---- is_leaf_by_cost: answers -------------------------------------------------------------------

static char *describe_decision(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("level %d of at most %d, %u sphere%s where %d make a leaf, a leaf costs %g "
                       "and the best split %g: found %d, expected %d",
                       in.level, in.maxDepth, in.n_spheres, plural(in.n_spheres),
                       in.targetElementsPerNode, LEAF_COST, in.best_cost, found, IS_LEAF);
}

const Function decision_08 = {"decisions", N_DECISIONS, sizeof(i32),
                              KNOWING(is_decision, describe_decision, leaf_known),
                              .counted = "nodes"};
