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
#define IS_FOUND(cost) is_near_cost(found, cost)

static int is_near_cost(double found, double cost)
{
    return fabs(found - cost) <= SAH_COST_TOLERANCE * fabs(cost);
}

static double stub_area(BBox3D box, u32 NONCE)
{
#include "08-surface-area-heuristic/surface_area.c"
}

// A cell's area as surface_area has it, or its stub.
static double area_of(const Job *job, BBox3D box)
{
    return job->is_alone ? stub_area(box, job->nonce) : sah_area(box);
}

// The areas of the lower child, of the higher one, and of the cell; and the children's spheres.
typedef struct Parts {
    double l, h, a;
    double n_l, n_h;
} Parts;

static Parts parts_of(const Job *job, CostJob in)
{
    return (Parts){area_of(job, sah_lower(in)), area_of(job, sah_higher(in)), area_of(job, in.box),
                   in.n_lower, in.n_higher};
}

static double tests_of(Parts p)
{
    return (p.l * p.n_l + p.h * p.n_h) / p.a;
}

static double with_tests(double n_expected)
{
    return SAH_TRAVERSAL + SAH_TEST * n_expected;
}

static double cost_of(const Job *job, CostJob in)
{
    return job->is_alone ? with_tests(tests_of(parts_of(job, in))) : sah_cost(in);
}

RIGHT(is_cost, IS_FOUND(cost_of(job, in)))

// ---- split_cost: mistakes -----------------------------------------------------------------------

// The expected number of tests, with another measure than the area.
static double tests_by(double (*size)(BBox3D box), CostJob in)
{
    return (size(sah_lower(in)) * in.n_lower + size(sah_higher(in)) * in.n_higher) / size(in.box);
}

static double side_of(BBox3D box, int axis)
{
    return (double)box.max[axis] - (double)box.min[axis];
}

#define ONE_DIVIDED "the area of each child is divided by the cell's, not that of one alone"

static double edges(BBox3D box)
{
    return side_of(box, 0) + side_of(box, 1) + side_of(box, 2);
}

static double volume(BBox3D box)
{
    return side_of(box, 0) * side_of(box, 1) * side_of(box, 2);
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
               ? of_step * SAH_TRAVERSAL + of_tests * SAH_TEST * tests_of(parts_of(job, in))
               : cost_of(job, in);
}

// Of the fraction each part is another: an area, a number of spheres; their difference.
static double fraction_of(Parts p, int way)
{
    const double areas[] = {p.l, p.h, p.a}, counts[] = {p.n_l, p.n_h, p.n_l + p.n_h},
                 divisors[] = {p.a, p.l + p.h, 1, p.l, p.h};
    const double lower = areas[way % 3] * counts[way / 3 % 3],
                 higher = areas[way / 9 % 3] * counts[way / 27 % 3];
    return (way / 81 % 2 ? lower - higher : lower + higher) / divisors[way / 162];
}

// All with more spheres in a child than that are wrong, and no others.
static int is_lost_above(u32 count, CostJob in, int is_right)
{
    return (in.n_lower > count || in.n_higher > count) != is_right;
}

KNOWN_LIST(cost_known)
{
    GIVEN;
    const Parts parts = parts_of(job, in);
    const double l = parts.l, h = parts.h, a = parts.a, n_l = parts.n_l, n_h = parts.n_h;
    const double tests = tests_of(parts), cost = cost_of(job, in);

    ANSWERS(by_edges, with_tests(tests_by(edges, in)),
            "that weighs by the lengths of edges: a ray in space meets a box by its surface");
    // Of a flat cell comes 0 / 0.
    EACH(by_volume, volume(in.box) == 0 || IS_FOUND(with_tests(tests_by(volume, in))),
         "that weighs by volume: so a point meets a box, and not a ray");
    ANSWERS(both_in_full, with_tests(n_l + n_h),
            "both children count in full, as if every ray met both");
    ANSWERS(no_traversal, (SAH_TEST * tests),
            "the step at the node itself is missing: KD_COST_TRAVERSAL");
    ANSWERS(no_test, SAH_TRAVERSAL + tests, "a test costs KD_COST_TEST, not 1");
    ANSWERS(constants_swapped, SAH_TEST + SAH_TRAVERSAL * tests,
            "the two constants stand in each other's place");
    ANSWERS(no_division, with_tests((tests * a)),
            "that is not divided by the area of the cell itself");
    ANSWERS(counts_swapped, with_tests((l * n_h + h * n_l) / a),
            "each child's area goes with the other one's spheres");
    ANSWERS(shares_of_sum, with_tests((l * n_l + h * n_h) / (l + h)),
            "the two probabilities do not add up to 1: a ray may meet both children");
    ANSWERS(no_both, with_tests(((a - h) * n_l + h * n_h) / a),
            "a ray that meets both children pays for both: nothing is taken off");
    ANSWERS(
        higher_is_rest, with_tests((l * n_l + (a - l) * n_h) / a),
        "that is as if a ray met one child alone: the second probability is not 1 minus the first");
    ANSWERS(lower_uncut, with_tests((a * n_l + h * n_h) / a),
            "the lower child's box is not cut at the plane");
    ANSWERS(higher_uncut, with_tests((l * n_l + a * n_h) / a),
            "the higher child's box is not cut at the plane");
    ANSWERS(cut_across_x, cost_of(job, across_x(in)),
            "the children are cut across x, whatever the split's axis is");
    ANSWERS(one_at_least, with_tests((l * fmax(n_l, 1) + h * fmax(n_h, 1)) / a),
            "a child without spheres costs no test");
    ANSWERS(whole_tests, with_tests(trunc(tests)),
            "the expected number of tests was cut to a whole number");
    ANSWERS(all_multiplied, (SAH_TRAVERSAL + SAH_TEST) * tests,
            "KD_COST_TRAVERSAL is added: what is expected multiplies KD_COST_TEST alone");
    ANSWERS(lower_tests, SAH_TRAVERSAL + (SAH_TEST * l * n_l + h * n_h) / a,
            "KD_COST_TEST multiplies the tests of both children, not of the lower one alone");
    ANSWERS(lower_only, with_tests((l * n_l) / a), "the higher child is missing");
    ANSWERS(higher_only, with_tests((h * n_h) / a), "the lower child is missing");
    ANSWERS(both_lower, with_tests(l * (n_l + n_h) / a),
            "both children's boxes are cut on the same side: one keeps the cell's minimum, the "
            "other its maximum");
    ANSWERS(both_higher, with_tests(h * (n_l + n_h) / a),
            "both children's boxes are cut on the same side: one keeps the cell's minimum, the "
            "other its maximum");
    ANSWERS(all_in_both, with_tests((l + h) * (n_l + n_h) / a),
            "each child counts its own spheres only, not those of both");
    ANSWERS(lower_undivided, with_tests(l * n_l + h * n_h / a), ONE_DIVIDED);
    ANSWERS(higher_undivided, with_tests(l * n_l / a + h * n_h), ONE_DIVIDED);
    ANSWERS(mean, with_tests(tests / 2),
            "the two parts add up: a sum of expected tests is no mean");
    ANSWERS(two_steps, SAH_TRAVERSAL + with_tests(tests),
            "KD_COST_TRAVERSAL is paid once for a split, not for each child");
    ANSWERS(all_divided, with_tests(tests) - SAH_TRAVERSAL + SAH_TRAVERSAL / a,
            "the step is paid in full: only the areas are divided by the cell's");
    ANSWERS(flat_is_missed,
            with_tests(((in.pos > in.box.min[in.axis]) * l * n_l +
                        (in.pos < in.box.max[in.axis]) * h * n_h) /
                       a),
            "a child that the plane leaves flat still has a surface, and rays meet it");

    EACH(bonus,
         IS_FOUND(with_bonus(job, in, 0.8, 0.8)) || IS_FOUND(with_bonus(job, in, 0.5, 0.5)) ||
             IS_FOUND(with_bonus(job, in, 1, 0.8)) || IS_FOUND(with_bonus(job, in, 1, 0.5)),
         "that a child is empty makes a split no cheaper: the formula has no bonus for it");
    ANSWERS(empty_saves_step, with_bonus(job, in, 0, 1),
            "the step is paid where a child is empty, too");
    ANSWERS(none_saves_step, n_l + n_h == 0 ? 0 : cost,
            "the step is paid where both children are empty, too");

    ANSWERS(empty_is_missed, n_l == 0 || n_h == 0 ? with_tests(n_l + n_h) : cost,
            "with one child empty all spheres of the other were counted in full: a ray meets it "
            "only with the probability area over area, too");
    ANSWERS(mean_area, with_tests((l + h) / 2 * (n_l + n_h) / a),
            "each child's area goes with its own spheres, not a mean area with all of them");
    ANSWERS(taken_off, SAH_TRAVERSAL - SAH_TEST * tests, "the step and the tests add up");
    ANSWERS(multiplied_by_cell, with_tests(tests * a * a),
            "that is multiplied by the area of the cell, and is to be divided by it");

    ANY(other_fraction, 810, IS_FOUND(with_tests(fraction_of(parts_of(job, in), way))),
        "each child's area times its own spheres, both added and divided by the cell's area: one "
        "of these parts is another");
    EACH(lost_signed, is_lost_above(INT32_MAX, in, is_cost(job, i, answers)),
         "only splits of very many spheres are wrong: 32 bits with a sign do not hold their count");
    EACH(lost_short, is_lost_above(UINT16_MAX, in, is_cost(job, i, answers)),
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
    const Job alone = {.nonce = whole->job.nonce, .is_alone = 1};
    const double *answers = function_answers(check->function, answers_section);
    int n_right = 0, n_following = 0;
    for (int k = 0; answers != NULL && k < check->range.n; k++) {
        const int i = range_at(check->range, k);
        const CostJob in = whole->costs[i];
        const double found = answers[i];
        n_right += is_near_cost(found, sah_cost(in));
        n_following += is_near_cost(found, cost_of(&alone, in));
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

static int is_leaf_08(LeafCostJob in)
{
    return in.level >= in.maxDepth || (int64_t)in.n_spheres <= in.targetElementsPerNode ||
           in.best_cost >= SAH_TEST * in.n_spheres;
}

RIGHT(is_decision, IS_FOUND(is_leaf_08(in)))

// ---- is_leaf_by_cost: mistakes ------------------------------------------------------------------

// One of the comparisons is another; or a leaf's cost is.
static int compares(double a, double b, int way)
{
    const int holds[] = {a<b, a <= b, a> b, a >= b, a == b, a != b};
    return holds[way];
}

static double other_leaf_cost(LeafCostJob in, int way)
{
    const double n = in.n_spheres;
    const double costs[] = {SAH_TRAVERSAL * n,
                            SAH_TRAVERSAL + SAH_TEST,
                            SAH_TEST + n,
                            SAH_TEST,
                            (SAH_TRAVERSAL + SAH_TEST) * n,
                            SAH_TEST * (double)in.targetElementsPerNode,
                            SAH_TEST * in.level,
                            SAH_TEST / n};
    return costs[way];
}

KNOWN_LIST(leaf_known)
{
    GIVEN;
    const double leaf_cost = SAH_TEST * in.n_spheres, target = in.targetElementsPerNode;
    const int is_deep = in.level >= in.maxDepth, is_small = in.n_spheres <= target,
              is_dear = in.best_cost >= leaf_cost;

    ANSWERS(level_more, in.level > in.maxDepth || is_small || is_dear,
            "on level maxDepth itself a node stays a leaf");
    ANSWERS(level_less, in.level + 1 >= in.maxDepth || is_small || is_dear,
            "a node on the level before maxDepth may be split");
    ANSWERS(fewer, is_deep || (int64_t)in.n_spheres < in.targetElementsPerNode || is_dear,
            "with just targetElementsPerNode spheres it stays a leaf");
    ANSWERS(equal_is_split, is_deep || is_small || in.best_cost > leaf_cost,
            "a split that costs as much as the leaf gains nothing");
    ANSWERS(no_depth, is_small || is_dear, "maxDepth is not looked at");
    ANSWERS(no_target, is_deep || is_dear, "targetElementsPerNode is not looked at");
    ANSWERS(no_cost, is_deep || is_small,
            "the cost does not end the splitting by itself, as it should");
    ANSWERS(
        leaf_steps, is_deep || is_small || in.best_cost >= leaf_cost + SAH_TRAVERSAL,
        "a leaf chooses no child: KD_COST_TRAVERSAL is in the split's cost alone, and stays there");
    ANSWERS(tests_cost_1, is_deep || is_small || in.best_cost >= in.n_spheres,
            "a test costs KD_COST_TEST, not 1");
    ANSWERS(reversed, is_deep || is_small || in.best_cost < leaf_cost,
            "the other way round: the cheaper of the two is right");
    ANSWERS(both_limits, (is_deep && is_small) || is_dear,
            "each limit ends the splitting by itself, not only both together");
    ANSWERS(is_signed, is_deep || (i32)in.n_spheres <= in.targetElementsPerNode || is_dear,
            "as an int the number of very many spheres is negative: the limit is to be unsigned, "
            "not the number signed");

    ANSWERS(level_equal, in.level == in.maxDepth || is_small || is_dear,
            "a level may also be beyond maxDepth: it is a limit, not one number");
    ANSWERS(target_equal, is_deep || (int64_t)in.n_spheres == in.targetElementsPerNode || is_dear,
            "there may also be fewer spheres than targetElementsPerNode: it is a limit, not one "
            "number");
    ANSWERS(both_strict,
            in.level > in.maxDepth || (int64_t)in.n_spheres < in.targetElementsPerNode || is_dear,
            "on level maxDepth itself, and with just targetElementsPerNode spheres, a node stays a "
            "leaf");
    ANSWERS(split_steps, is_deep || is_small || in.best_cost + SAH_TRAVERSAL >= leaf_cost,
            "KD_COST_TRAVERSAL is in best_cost already: it counts once");
    ANSWERS(all_must, is_deep && is_small && is_dear, EACH_ENOUGH);
    ANSWERS(limit_and_cost, (is_deep || is_small) && is_dear, EACH_ENOUGH);
    ANSWERS(small_and_dear, is_deep || (is_small && is_dear), EACH_ENOUGH);
    ANSWERS(deep_and_dear, (is_deep && is_dear) || is_small, EACH_ENOUGH);
    ANSWERS(inverted, !is_leaf_08(in), "1 and 0 are swapped: 1 for a leaf");
    ANSWERS(limits_swapped,
            in.level >= in.targetElementsPerNode || (int64_t)in.n_spheres <= in.maxDepth || is_dear,
            "the two limits are swapped: maxDepth is one of levels");
#define COST_CUT "a cost was cut to a whole number: half a step makes a difference, too"
    ANSWERS(leaf_cut, is_deep || is_small || in.best_cost >= trunc(leaf_cost), COST_CUT);
    // What INFINITY is as a whole number, C leaves open.
    EACH(split_cut,
         isinf(in.best_cost) || IS_FOUND(is_deep || is_small || trunc(in.best_cost) >= leaf_cost),
         COST_CUT);
    EACH(both_cut,
         isinf(in.best_cost) ||
             IS_FOUND(is_deep || is_small || trunc(in.best_cost) >= trunc(leaf_cost)),
         COST_CUT);
    ANY(other_depth, 6, IS_FOUND(compares(in.level, in.maxDepth, way) || is_small || is_dear),
        "the level is compared with maxDepth in another way: from maxDepth on a node is a leaf");
    ANY(other_target, 6, IS_FOUND(is_deep || compares(in.n_spheres, target, way) || is_dear),
        "the spheres are compared with targetElementsPerNode in another way: up to so many are a "
        "leaf");
    ANY(other_cost, 6, IS_FOUND(is_deep || is_small || compares(in.best_cost, leaf_cost, way)),
        "the costs are compared in another way: where a split is not cheaper than the leaf, it is "
        "one");

    ANY(other_leaf, 8, IS_FOUND(is_deep || is_small || in.best_cost >= other_leaf_cost(in, way)),
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
                       in.targetElementsPerNode, SAH_TEST * in.n_spheres, in.best_cost, found,
                       is_leaf_08(in));
}

const Function decision_08 = {"decisions", N_DECISIONS, sizeof(i32),
                              KNOWING(is_decision, describe_decision, leaf_known),
                              .counted = "nodes"};
