// Lab 02: is_leaf and split_box on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d_tree.h"
#include "words.h"

#include <limits.h>
#include <math.h>

// ---- is_leaf ------------------------------------------------------------------------------------

// What is_leaf asks for, with a known mistake in it.
typedef struct LeafRules {
    int level_more, count_more;        // added to the level, and to targetElementsPerNode
    int most_failed;                   // 0: MAX_FAILED_SPLITS
    int is_level_free, is_count_free;  // not asked
    int wants_both;                    // the level and the count
    int adds_failed;                   // to the level
    int is_signed;                     // the number of circles
    KdTreeLimits limits;               // in place of those that are given; 0: none
    u32 count_bits, level_bits;        // of the number of circles, and of the level, no more are
                                       // kept; 0: all
} LeafRules;

static int leaf_by(LeafJob in, const LeafRules *rules)
{
    const int is_given = rules->limits.maxDepth == 0;
    const int maxDepth = is_given ? in.maxDepth : rules->limits.maxDepth;
    const int target = (is_given ? in.targetElementsPerNode : rules->limits.targetElementsPerNode) +
                       rules->count_more;
    const int whole = in.level + rules->level_more + (rules->adds_failed ? in.n_failed : 0);
    const int level = rules->level_bits != 0 ? (int)((u32)whole & rules->level_bits) : whole;
    const u32 n_circles = rules->count_bits != 0 ? in.n_circles & rules->count_bits : in.n_circles;
    const int is_low = !rules->is_level_free && level >= maxDepth;
    const int is_small =
        !rules->is_count_free && (rules->is_signed ? (i32)n_circles : (int64_t)n_circles) <= target;
    const int is_hopeless =
        in.n_failed >= (rules->most_failed != 0 ? rules->most_failed : MAX_FAILED_SPLITS);
    return (rules->wants_both ? is_low && is_small : is_low || is_small) || is_hopeless;
}

static const struct {
    const char *says;
    LeafRules rules;
} leaf_mistakes[] = {
    {"your answers are those of level > maxDepth: a node on level maxDepth is a leaf",
     {.level_more = -1}},
    {"your answers are those of a root on level 0: levels count from 1", {.level_more = 1}},
    {"your answers are those of n_circles < targetElementsPerNode: exactly that many are few "
     "enough",
     {.count_more = -1}},
    {"the level was not asked for", {.is_level_free = 1}},
    {"the number of circles was not asked for", {.is_count_free = 1}},
    {"your answers are those of && between level and count: one reason is enough",
     {.wants_both = 1}},
    {"your answers are those of n_failed > MAX_FAILED_SPLITS: exactly that many are enough",
     {.most_failed = MAX_FAILED_SPLITS + 1}},
    {"failed splits were not asked for", {.most_failed = INT_MAX}},
    {"one failed split is no reason to stop, only MAX_FAILED_SPLITS are", {.most_failed = 1}},
    {"two failed splits are no reason to stop, only MAX_FAILED_SPLITS are", {.most_failed = 2}},
    {"three failed splits are no reason to stop, only MAX_FAILED_SPLITS are", {.most_failed = 3}},
    {"your answers are those of a level to which failed splits were added", {.adds_failed = 1}},
    {"your answers are those of limits 16 and 8, whatever limits are given", {.limits = {16, 8}}},
    {"your answers are those of limits 4 and 1, whatever limits are given", {.limits = {4, 1}}},
    {"your answers are those of a level cut to 8 bits", {.level_bits = 0xff}},
    {"your answers are those of a count cut to 8 bits", {.count_bits = 0xff}},
    {"your answers are those of a count cut to 16 bits", {.count_bits = 0xffff}},
    {"your answers are those of a count with a sign: n_circles has none", {.is_signed = 1}},
};

static int is_of_leaf_rules(const Job02 *job, const i32 *found, const LeafRules *rules)
{
    int i = 0;
    while (i < N_LEAVES && (found[i] != 0) == leaf_by(job->leaves[i], rules)) {
        i++;
    }
    return i == N_LEAVES;
}

// What all answers look like.
static const char *explain_leaves(const Job02 *job, const i32 *found)
{
    static const LeafRules right = {0};
    if (is_of_leaf_rules(job, found, &right)) {
        return JUST_1_AND_0;
    }
    for (int m = 0; m < COUNT(leaf_mistakes); m++) {
        if (is_of_leaf_rules(job, found, &leaf_mistakes[m].rules)) {
            return leaf_mistakes[m].says;
        }
    }
    return NULL;
}

static Diagnosis leaf_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const LeafJob in = job->leaves[i];
    const i32 *found = answers;
    const int expected = oracle_is_leaf(in.level, in.n_circles, in.n_failed,
                                        (KdTreeLimits){in.maxDepth, in.targetElementsPerNode});
    return found[i] == expected
               ? NOTHING_WRONG
               : diagnosis_of(message_new("level %d, %u circle%s, %d failed split%s, maxDepth %d, "
                                          "targetElementsPerNode %d: found %d, expected %d",
                                          in.level, in.n_circles, plural(in.n_circles), in.n_failed,
                                          plural((unsigned)in.n_failed), in.maxDepth,
                                          in.targetElementsPerNode, found[i], expected),
                              (Cause){.says = explain_leaves(job, found)});
}

const Function is_leaf_02 = {"leaves", N_LEAVES, sizeof(i32), .fault = leaf_fault};

// ---- split_box ----------------------------------------------------------------------------------

static int is_box(BBox2D a, BBox2D b)
{
    return a.minX == b.minX && a.maxX == b.maxX && a.minY == b.minY && a.maxY == b.maxY;
}

// Which side was split: 'x', 'y', or '?' when neither was, or both.
static int split_side(const BBox2D found[2])
{
    const int x = found[0].minX != found[1].minX || found[0].maxX != found[1].maxX;
    const int y = found[0].minY != found[1].minY || found[0].maxY != found[1].maxY;
    return x && !y ? 'x' : y && !x ? 'y' : '?';
}

// The halves of a box that is split across this side, x or y.
static void halve(BBox2D box, int side, BBox2D halves[2])
{
    halves[0] = halves[1] = box;
    if (side == 'x') {
        halves[0].maxX = halves[1].minX = (float)(((double)box.minX + box.maxX) / 2);
    } else {
        halves[0].maxY = halves[1].minY = (float)(((double)box.minY + box.maxY) / 2);
    }
}

static int longer_side(BBox2D box)
{
    return (double)box.maxX - box.minX >= (double)box.maxY - box.minY ? 'x' : 'y';
}

static Diagnosis describe_split(BBox2D box, const BBox2D found[2], const BBox2D expected[2],
                                const char *why)
{
    return diagnosis_of(message_new("box %s: found left %s and right %s, expected left %s",
                                    words_box2d(box).text, words_box2d(found[0]).text,
                                    words_box2d(found[1]).text, words_box2d(expected[0]).text),
                        (Cause){.says = why});
}

// How much wider than high a box is.
static double wider_by(BBox2D box)
{
    return ((double)box.maxX - box.minX) - ((double)box.maxY - box.minY);
}

// Is the side that was split by all answers that of the larger upper corner?
static int sides_follow_corners(const Job02 *job, const BBox2D *found)
{
    int i = 0;
    while (i < N_SPLITS &&
           split_side(found + 2 * i) == (job->splits[i].maxX >= job->splits[i].maxY ? 'x' : 'y')) {
        i++;
    }
    return i == N_SPLITS;
}

// Are only those boxes wrong of which both sides are equal?
static int are_only_squares_wrong(const Job02 *job, const BBox2D *found)
{
    int i = 0;
    while (i < N_SPLITS && (wider_by(job->splits[i]) == 0 ||
                            split_side(found + 2 * i) == longer_side(job->splits[i]))) {
        i++;
    }
    return i == N_SPLITS;
}

// Why the side that was split of box number i is the wrong one, or NULL.
static const char *explain_side(const Job02 *job, const BBox2D *found, int i)
{
    const BBox2D box = job->splits[i];
    const double apart = wider_by(box);
    const double width = (double)box.maxX - box.minX, height = (double)box.maxY - box.minY;
    if (split_side(found + 2 * i) == '?') {
        return "nothing was split, or both sides";
    }
    if (sides_follow_corners(job, found)) {
        return "maxX and maxY were compared: the lengths of the sides count";
    }
    if (apart == 0) {
        return are_only_squares_wrong(job, found) ? "where both sides are equal, x is split" : NULL;
    }
    return -apart < height / 1024 && apart < width / 1024
               ? "the sides are not equal, if nearly, and the longer one is split"
               : "the shorter side was split";
}

static Diagnosis split_longer_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const BBox2D box = job->splits[i];
    const BBox2D *found = (const BBox2D *)answers + 2 * i;
    const int longer = longer_side(box), side = split_side(found);
    BBox2D expected[2];
    halve(box, longer, expected);
    return side == longer ? NOTHING_WRONG
                          : describe_split(box, found, expected, explain_side(job, answers, i));
}

// The borders that a known mistake moves: left's upper one and right's lower one.
typedef void Middle(float min, float max, float borders[2]);

static void half_the_width(float min, float max, float borders[2])
{
    borders[0] = borders[1] = (max - min) / 2;
}

static void cut_to_whole(float min, float max, float borders[2])
{
    borders[0] = borders[1] = truncf((min + max) / 2);
}

static void rounded_down(float min, float max, float borders[2])
{
    borders[0] = borders[1] = floorf((min + max) / 2);
}

static void from_moved_border(float min, float max, float borders[2])
{
    borders[0] = (min + max) / 2;
    borders[1] = (min + borders[0]) / 2;
}

static const struct {
    Middle *middle;
    const char *says;
} middles[] = {
    {half_the_width, "that is half the width: the cell does not begin at 0"},
    {cut_to_whole, "the middle was made a whole number"},
    {rounded_down, "the middle was made a whole number"},
    {from_moved_border, "the second border was computed from the first after that had moved"},
};

// A pair of halves, one border of each moved.
static int has_borders(BBox2D box, int side, const BBox2D found[2], const float borders[2])
{
    BBox2D halves[2] = {box, box};
    if (side == 'x') {
        halves[0].maxX = borders[0];
        halves[1].minX = borders[1];
    } else {
        halves[0].maxY = borders[0];
        halves[1].minY = borders[1];
    }
    return is_box(found[0], halves[0]) && is_box(found[1], halves[1]);
}

// Does every answer come of this mistake?
static int is_middle(const Job02 *job, const BBox2D *found, Middle *middle)
{
    int i = 0, follows = 1;
    for (; follows && i < N_SPLITS; i++) {
        const BBox2D box = job->splits[i];
        const int side = split_side(found + 2 * i);
        float borders[2];
        middle(side == 'x' ? box.minX : box.minY, side == 'x' ? box.maxX : box.maxY, borders);
        follows = side == '?' ? 0 : has_borders(box, side, found + 2 * i, borders);
    }
    return follows;
}

// Why the borders are where they are. Expected are those of the same side.
static const char *explain_middle(const Job02 *job, const BBox2D *all, const BBox2D found[2],
                                  const BBox2D expected[2])
{
    for (int m = 0; m < COUNT(middles); m++) {
        if (is_middle(job, all, middles[m].middle)) {
            return middles[m].says;
        }
    }
    return is_box(found[0], expected[1]) && is_box(found[1], expected[0])
               ? "left and right are swapped"
           : is_box(found[0], expected[0]) || is_box(found[1], expected[1])
               ? "one half is right and the other is not: both have the border in the middle"
               : NULL;
}

// Where along the side that the student has split, be it the right one or not.
static Diagnosis split_middle_fault(const void *pointer, int i, const void *answers)
{
    const Job02 *job = pointer;
    const BBox2D box = job->splits[i];
    const BBox2D *found = (const BBox2D *)answers + 2 * i;
    const int side = split_side(found);
    BBox2D expected[2];
    halve(box, side == '?' ? longer_side(box) : side, expected);
    return is_box(found[0], expected[0]) && is_box(found[1], expected[1])
               ? NOTHING_WRONG
               : describe_split(box, found, expected,
                                explain_middle(job, answers, found, expected));
}

const Function split_longer_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  .fault = split_longer_fault};
const Function split_middle_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  .fault = split_middle_fault};
