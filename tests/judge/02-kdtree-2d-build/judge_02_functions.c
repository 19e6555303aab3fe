// Lab 02: is_leaf and split_box on the job's inputs. See judge_02.h.
#include "judge_02.h"

#include "message.h"
#include "oracle2d_tree.h"
#include "words.h"

#include <math.h>

// ---- is_leaf ------------------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const LeafJob in = ((const Job02 *)job)->leaves[i];                                            \
    const int found = ((const i32 *)answers)[i]
#define IS_FOUND(expected) (found == (expected))

#define LIMITS ((KdTreeLimits){in.maxDepth, in.targetElementsPerNode})
#define LEAF_02 oracle_is_leaf(in.level, in.n_circles, in.n_failed, LIMITS)

RIGHT(is_right_leaf, IS_FOUND(LEAF_02))

#define LOW (in.level >= in.maxDepth)
#define FEW (in.n_circles <= (u32)in.targetElementsPerNode)
#define FAILED(n) (in.n_failed >= (n))
#define HOPELESS FAILED(MAX_FAILED_SPLITS)

#define OTHER_LIMIT "one of the three numbers was compared with what is the limit of another"
#define LEAF_WHERE(name, low, few, hopeless, ...)                                                  \
    ANSWERS(name, (low) || (few) || (hopeless), __VA_ARGS__)
#define N_CIRCLES (int64_t)in.n_circles

KNOWN_LIST(known_of_leaf)
{
    GIVEN;

    EACH(just_1_and_0, (found != 0) == LEAF_02, JUST_1_AND_0);
    ANSWERS(one_level_more, in.level > in.maxDepth || FEW || HOPELESS,
            "your answers are those of level > maxDepth: a node on level maxDepth is a leaf");
    ANSWERS(one_level_less, in.level + 1 >= in.maxDepth || FEW || HOPELESS,
            "your answers are those of a root on level 0: levels count from 1");
    ANSWERS(fewer, LOW || in.n_circles < (u32)in.targetElementsPerNode || HOPELESS,
            "your answers are those of n_circles < targetElementsPerNode: exactly that many are "
            "few enough");
    ANSWERS(without_level, FEW || HOPELESS, "the level was not asked for");
    ANSWERS(without_count, LOW || HOPELESS, "the number of circles was not asked for");
#define BOTH_NEEDED "your answers are those of && between two reasons: one reason is enough"
    ANSWERS(level_and_count, (LOW && FEW) || HOPELESS, BOTH_NEEDED);
    ANSWERS(level_and_failed, (LOW && HOPELESS) || FEW, BOTH_NEEDED);
    ANSWERS(count_and_failed, LOW || (FEW && HOPELESS), BOTH_NEEDED);
    ANSWERS(level_and_rest, LOW && (FEW || HOPELESS), BOTH_NEEDED);
    ANSWERS(count_and_rest, FEW && (LOW || HOPELESS), BOTH_NEEDED);
    ANSWERS(failed_and_rest, HOPELESS && (LOW || FEW), BOTH_NEEDED);
    ANSWERS(all_three, LOW && FEW && HOPELESS, "one of the three reasons is enough, not only all");
#define BEYOND                                                                                     \
    "your answers are those of == with a limit: it counts, and so does everything beyond it"
    ANSWERS(just_level, in.level == in.maxDepth || FEW || HOPELESS, BEYOND);
    ANSWERS(just_count, LOW || in.n_circles == (u32)in.targetElementsPerNode || HOPELESS, BEYOND);
    ANSWERS(just_failed, LOW || FEW || in.n_failed == MAX_FAILED_SPLITS, BEYOND);
#define TURNED "your answers are those of a comparison the wrong way round"
    ANSWERS(level_turned, in.level <= in.maxDepth || FEW || HOPELESS, TURNED);
    ANSWERS(level_below, in.level < in.maxDepth || FEW || HOPELESS, TURNED);
    ANSWERS(count_turned, LOW || in.n_circles >= (u32)in.targetElementsPerNode || HOPELESS, TURNED);
    ANSWERS(count_above, LOW || !FEW || HOPELESS, TURNED);
    ANSWERS(failed_turned, LOW || FEW || in.n_failed <= MAX_FAILED_SPLITS, TURNED);
    ANSWERS(failed_below, LOW || FEW || !HOPELESS, TURNED);
    ANSWERS(contrary, !LEAF_02, "1 and 0 are swapped: 1 is a leaf");
    ANSWERS(one_failed_more, LOW || FEW || in.n_failed > MAX_FAILED_SPLITS,
            "your answers are those of n_failed > MAX_FAILED_SPLITS: exactly that many are enough");
    ANSWERS(without_failed, LOW || FEW,
            "failed splits never make a leaf there: MAX_FAILED_SPLITS of them do");
    ANSWERS(limits_swapped,
            in.level >= in.targetElementsPerNode || in.n_circles <= (u32)in.maxDepth || HOPELESS,
            "the two limits are in each other's places");
    LEAF_WHERE(level_to_target, in.level >= in.targetElementsPerNode, FEW, HOPELESS, OTHER_LIMIT);
    LEAF_WHERE(level_to_failed, in.level >= MAX_FAILED_SPLITS, FEW, HOPELESS, OTHER_LIMIT);
    LEAF_WHERE(count_to_depth, LOW, N_CIRCLES <= in.maxDepth, HOPELESS, OTHER_LIMIT);
    LEAF_WHERE(count_to_failed, LOW, N_CIRCLES <= MAX_FAILED_SPLITS, HOPELESS, OTHER_LIMIT);
    LEAF_WHERE(count_to_level, LOW, N_CIRCLES <= in.level, HOPELESS, OTHER_LIMIT);
    LEAF_WHERE(failed_to_target, LOW, FEW, FAILED(in.targetElementsPerNode), OTHER_LIMIT);
    LEAF_WHERE(failed_to_level, LOW, FEW, FAILED(in.level), OTHER_LIMIT);
    LEAF_WHERE(one_circle_more, LOW, N_CIRCLES <= 1LL + in.targetElementsPerNode, HOPELESS,
               "one circle more than targetElementsPerNode is not few enough");

#define TARGET_IGNORED                                                                             \
    "your answers are those of a number of your own: targetElementsPerNode says what is few"
    ANSWERS(none_left, LOW || in.n_circles == 0 || HOPELESS, TARGET_IGNORED);
    ANSWERS(one_left, LOW || in.n_circles <= 1 || HOPELESS, TARGET_IGNORED);
    ANSWERS(failed_added_beyond, in.level + in.n_failed > in.maxDepth || FEW || HOPELESS,
            "your answers are those of a level to which failed splits were added");
    ANSWERS(one_failed, LOW || FEW || FAILED(1),
            "one failed split is no reason to stop, only MAX_FAILED_SPLITS are");
    ANSWERS(two_failed, LOW || FEW || FAILED(2),
            "two failed splits are no reason to stop, only MAX_FAILED_SPLITS are");
    ANSWERS(three_failed, LOW || FEW || FAILED(3),
            "three failed splits are no reason to stop, only MAX_FAILED_SPLITS are");
    ANSWERS(failed_added, in.level + in.n_failed >= in.maxDepth || FEW || HOPELESS,
            "your answers are those of a level to which failed splits were added");
    ANSWERS(limits_16_8, in.level >= 16 || in.n_circles <= 8 || HOPELESS,
            "your answers are those of limits 16 and 8, whatever limits are given");
    ANSWERS(limits_4_1, in.level >= 4 || in.n_circles <= 1 || HOPELESS,
            "your answers are those of limits 4 and 1, whatever limits are given");
    ANSWERS(level_in_8_bits, (in.level & 0xff) >= in.maxDepth || FEW || HOPELESS,
            "your answers are those of a level cut to 8 bits");
    ANSWERS(count_in_8_bits,
            LOW || (int)(in.n_circles & 0xff) <= in.targetElementsPerNode || HOPELESS,
            "your answers are those of a count cut to 8 bits");
    ANSWERS(count_in_16_bits,
            LOW || (int)(in.n_circles & 0xffff) <= in.targetElementsPerNode || HOPELESS,
            "your answers are those of a count cut to 16 bits");
    ANSWERS(signed_count, LOW || (i32)in.n_circles <= in.targetElementsPerNode || HOPELESS,
            "your answers are those of a count with a sign: n_circles has none");
    return NO_MORE;
}

static char *describe_leaf(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("level %d, %u circle%s, %d failed split%s, maxDepth %d, "
                       "targetElementsPerNode %d: found %d, expected %d",
                       in.level, in.n_circles, plural(in.n_circles), in.n_failed,
                       plural((unsigned)in.n_failed), in.maxDepth, in.targetElementsPerNode, found,
                       LEAF_02);
}

const Function is_leaf_02 = {"leaves", N_LEAVES, sizeof(i32),
                             KNOWING(is_right_leaf, describe_leaf, known_of_leaf),
                             .knows_constant = 1};
#undef GIVEN
#undef IS_FOUND

// ---- split_box ----------------------------------------------------------------------------------

typedef enum Side { SIDE_X, SIDE_Y, SIDE_NONE } Side;

// Which side was split: none where neither was, or both.
static Side side_of(const BBox2D found[2])
{
    const int x = found[0].minX != found[1].minX || found[0].maxX != found[1].maxX;
    const int y = found[0].minY != found[1].minY || found[0].maxY != found[1].maxY;
    return x && !y ? SIDE_X : y && !x ? SIDE_Y : SIDE_NONE;
}

// Is this the lower or the upper part of a box that is split across a side, with this border?
static int is_part(BBox2D found, BBox2D in, Side side, int is_upper, float border)
{
    if (is_upper) {
        *(side == SIDE_X ? &in.minX : &in.minY) = border;
    } else {
        *(side == SIDE_X ? &in.maxX : &in.maxY) = border;
    }
    return found.minX == in.minX && found.maxX == in.maxX && found.minY == in.minY &&
           found.maxY == in.maxY;
}

static int is_split_at(const BBox2D found[2], BBox2D in, Side side, float border)
{
    return is_part(found[0], in, side, 0, border) && is_part(found[1], in, side, 1, border);
}

#define GIVEN                                                                                      \
    const BBox2D in = ((const Job02 *)job)->splits[i];                                             \
    const BBox2D *found = (const BBox2D *)answers + 2 * i;                                         \
    const Side side = side_of(found);                                                              \
    (void)side

// Which side: the longer one. Across a side of no length nothing is seen of a split.
#define WIDTH ((double)in.maxX - in.minX)
#define HEIGHT ((double)in.maxY - in.minY)
#define IS_FOUND(x_is_split)                                                                       \
    ((x_is_split) ? side == SIDE_X || (WIDTH == 0 && side == SIDE_NONE)                            \
                  : side == SIDE_Y || (HEIGHT == 0 && side == SIDE_NONE))

RIGHT(is_longer, IS_FOUND(WIDTH >= HEIGHT))

#define NEARLY_EQUAL                                                                               \
    (WIDTH != HEIGHT && HEIGHT - WIDTH < HEIGHT / 1024 && WIDTH - HEIGHT < WIDTH / 1024)
#define SHORTER "the shorter side was split"
#define NOT_EQUAL "the sides are not equal, if nearly: the longer one is split"

KNOWN_LIST(known_of_longer)
{
    GIVEN;

#define WRONG_SIDE "a side was computed wrongly: it is its own maximum minus its own minimum"
    ANSWERS(sum_of_x, (double)in.maxX + in.minX >= HEIGHT, WRONG_SIDE);
    ANSWERS(sum_of_y, WIDTH >= (double)in.maxY + in.minY, WRONG_SIDE);
    ANSWERS(sums, (double)in.maxX + in.minX >= (double)in.maxY + in.minY, WRONG_SIDE);
    ANSWERS(x_is_max, in.maxX >= HEIGHT, WRONG_SIDE);
    ANSWERS(y_is_max, WIDTH >= in.maxY, WRONG_SIDE);
    // So are a width that begins at minY, and a height that begins at minX, or ends at the other's end.
    ANSWERS(by_corners, in.maxX >= in.maxY,
            "your answers are those of maxX against maxY: the lengths of the sides count");
    ANSWERS(by_low_corners, in.minX <= in.minY,
            "your answers are those of minX against minY: the lengths of the sides count");
    ANSWERS(always_x, 1, SHORTER);
    ANSWERS(always_y, 0, SHORTER);
    ANSWERS(whole_numbers, (int)WIDTH >= (int)HEIGHT, NOT_EQUAL);
    EACH(shorter, WIDTH == HEIGHT || IS_FOUND(WIDTH < HEIGHT), SHORTER);
    ONLY(none_split, side == SIDE_NONE, "nothing was split, or both sides");
    ONLY(equal, side != SIDE_NONE && WIDTH == HEIGHT, "where both sides are equal, x is split");
    ONLY(nearly_equal, side != SIDE_NONE && NEARLY_EQUAL, NOT_EQUAL);
    ONLY(some_shorter, side != SIDE_NONE && WIDTH != HEIGHT && !NEARLY_EQUAL, SHORTER);
    return NO_MORE;
}

// Where: along the side that the student has split, be it the right one or not. Across a side of no
// length nothing is seen of a split.
#define OWN_SIDE                                                                                   \
    (side != SIDE_NONE ? side                                                                      \
     : WIDTH == 0      ? SIDE_X                                                                    \
     : HEIGHT == 0     ? SIDE_Y                                                                    \
     : WIDTH >= HEIGHT ? SIDE_X                                                                    \
                       : SIDE_Y)
#define LOW_END (OWN_SIDE == SIDE_X ? in.minX : in.minY)
#define HIGH_END (OWN_SIDE == SIDE_X ? in.maxX : in.maxY)
#define MIDDLE (float)(((double)LOW_END + HIGH_END) / 2)
#define IS_LOWER(half, border) is_part(found[half], in, OWN_SIDE, 0, border)
#define IS_UPPER(half, border) is_part(found[half], in, OWN_SIDE, 1, border)
#undef IS_FOUND
#define IS_FOUND(border) is_split_at(found, in, OWN_SIDE, border)

RIGHT(is_middle, IS_FOUND(MIDDLE))

// Wrong on both sides, or on one of them.
#define BORDER(name, border, ...)                                                                  \
    ANSWERS(name, border, __VA_ARGS__);                                                            \
    ANSWERS(name##_of_x, OWN_SIDE == SIDE_X ? (border) : MIDDLE, __VA_ARGS__);                     \
    ANSWERS(name##_of_y, OWN_SIDE == SIDE_Y ? (border) : MIDDLE, __VA_ARGS__)
#define LENGTH (HIGH_END - LOW_END)
#define OTHER_LOW (OWN_SIDE == SIDE_X ? in.minY : in.minX)
#define OTHER_HIGH (OWN_SIDE == SIDE_X ? in.maxY : in.maxX)

#define NO_LENGTH(half)                                                                            \
    (OWN_SIDE == SIDE_X ? found[half].minX == found[half].maxX                                     \
                        : found[half].minY == found[half].maxY)

#define OWN_BORDER (OWN_SIDE == SIDE_X ? found[0].maxX : found[0].maxY)

KNOWN_LIST(known_of_middle)
{
    GIVEN;

    BORDER(half_the_length, LENGTH / 2, "that is half of a length: the cell does not begin at 0");
    BORDER(half_of_max, HIGH_END / 2,
           "that is half of the upper border: the cell does not begin at 0");
    BORDER(behind_max, HIGH_END + LENGTH / 2,
           "half the length was added to the upper border, not to the lower one");
    BORDER(before_min, LOW_END - LENGTH / 2,
           "half the length was taken off the lower border: it is to be added");
    BORDER(middle_added, LOW_END + MIDDLE, "the middle was added to the lower border once more");
    BORDER(not_halved, HIGH_END, "the whole length was added to the lower border, not half of it");
    BORDER(sum_not_halved, LOW_END + HIGH_END, "the sum of the borders was not halved");
    BORDER(doubled, LOW_END + LENGTH * 2, "the length was doubled, not halved");
    BORDER(other_middle, (float)(((double)OTHER_LOW + OTHER_HIGH) / 2),
           "that is the middle of the other side's borders");
    BORDER(from_other_low, OTHER_LOW + LENGTH / 2,
           "the middle was counted from the lower border of the other side");
#define OTHER_LENGTH "half the length of the other side was added"
    BORDER(other_length, LOW_END + (OTHER_HIGH - OTHER_LOW) / 2, OTHER_LENGTH);
#define MIXED_LENGTH "a length was computed wrongly: it is a maximum minus the minimum of that side"
    BORDER(length_from_other_low, LOW_END + (HIGH_END - OTHER_LOW) / 2, MIXED_LENGTH);
    BORDER(length_to_other_high, LOW_END + (OTHER_HIGH - LOW_END) / 2, MIXED_LENGTH);
#define WHOLE_LENGTH "the length of a side was made a whole number"
    BORDER(whole_length, LOW_END + truncf(LENGTH) / 2, WHOLE_LENGTH);
    BORDER(whole_half, LOW_END + truncf(LENGTH / 2), WHOLE_LENGTH);
#define WHOLE_MIDDLE "the middle was made a whole number"
    BORDER(cut_to_whole, truncf(MIDDLE), WHOLE_MIDDLE);
    BORDER(rounded_down, floorf(MIDDLE), WHOLE_MIDDLE);
    EACH(border_moved, IS_LOWER(0, MIDDLE) && IS_UPPER(1, (LOW_END + MIDDLE) / 2),
         "the second border was computed from the first after that had moved");
    ONLY(swapped, IS_LOWER(1, MIDDLE) && IS_UPPER(0, MIDDLE), "left and right are swapped");
    ONLY(both_moved, NO_LENGTH(0) || NO_LENGTH(1),
         "both borders of a half are the same: of each half the split moves one");
    ONLY(one_right, IS_LOWER(0, MIDDLE) || IS_UPPER(1, MIDDLE),
         "one half is right and the other is not: both have the border in the middle");
    ONLY(elsewhere, side != SIDE_NONE && IS_FOUND(OWN_BORDER),
         "both halves have the same border, and it is not in the middle");
    return NO_MORE;
}

// Facts: with what is expected on the left, across the right side or across the student's.
static char *describe_split(BBox2D box, const BBox2D found[2], BBox2D left)
{
    return message_new("box %s: found left %s and right %s, expected left %s",
                       words_box2d(box).text, words_box2d(found[0]).text,
                       words_box2d(found[1]).text, words_box2d(left).text);
}

static char *describe_longer(const void *job, int i, const void *answers)
{
    GIVEN;
    BBox2D halves[2];
    oracle2d_halves(in, halves);
    return describe_split(in, found, halves[0]);
}

static char *describe_middle(const void *job, int i, const void *answers)
{
    GIVEN;
    BBox2D left = in;
    *(OWN_SIDE == SIDE_X ? &left.maxX : &left.maxY) = MIDDLE;
    return describe_split(in, found, left);
}

const Function split_longer_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  KNOWING(is_longer, describe_longer, known_of_longer)};
const Function split_middle_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  KNOWING(is_middle, describe_middle, known_of_middle)};
