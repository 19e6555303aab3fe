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

EACH(just_1_and_0, (found != 0) == LEAF_02, JUST_1_AND_0)
ANSWERS(one_level_more, in.level > in.maxDepth || FEW || HOPELESS,
        "your answers are those of level > maxDepth: a node on level maxDepth is a leaf")
ANSWERS(one_level_less, in.level + 1 >= in.maxDepth || FEW || HOPELESS,
        "your answers are those of a root on level 0: levels count from 1")
ANSWERS(fewer, LOW || in.n_circles < (u32)in.targetElementsPerNode || HOPELESS,
        "your answers are those of n_circles < targetElementsPerNode: exactly that many are few "
        "enough")
ANSWERS(without_level, FEW || HOPELESS, "the level was not asked for")
ANSWERS(without_count, LOW || HOPELESS, "the number of circles was not asked for")
#define BOTH_NEEDED "your answers are those of && between two reasons: one reason is enough"
ANSWERS(level_and_count, (LOW && FEW) || HOPELESS, BOTH_NEEDED)
ANSWERS(level_and_failed, (LOW && HOPELESS) || FEW, BOTH_NEEDED)
ANSWERS(count_and_failed, LOW || (FEW && HOPELESS), BOTH_NEEDED)
ANSWERS(level_and_rest, LOW && (FEW || HOPELESS), BOTH_NEEDED)
ANSWERS(count_and_rest, FEW && (LOW || HOPELESS), BOTH_NEEDED)
ANSWERS(failed_and_rest, HOPELESS && (LOW || FEW), BOTH_NEEDED)
ANSWERS(all_three, LOW &&FEW &&HOPELESS, "one of the three reasons is enough, not only all")
#define BEYOND "a limit itself counts, and so does everything beyond it"
ANSWERS(just_level, in.level == in.maxDepth || FEW || HOPELESS, BEYOND)
ANSWERS(just_count, LOW || in.n_circles == (u32)in.targetElementsPerNode || HOPELESS, BEYOND)
ANSWERS(just_failed, LOW || FEW || in.n_failed == MAX_FAILED_SPLITS, BEYOND)
#define TURNED "your answers are those of a comparison the wrong way round"
ANSWERS(level_turned, in.level <= in.maxDepth || FEW || HOPELESS, TURNED)
ANSWERS(level_below, in.level < in.maxDepth || FEW || HOPELESS, TURNED)
ANSWERS(count_turned, LOW || in.n_circles >= (u32)in.targetElementsPerNode || HOPELESS, TURNED)
ANSWERS(count_above, LOW || !FEW || HOPELESS, TURNED)
ANSWERS(failed_turned, LOW || FEW || in.n_failed <= MAX_FAILED_SPLITS, TURNED)
ANSWERS(failed_below, LOW || FEW || !HOPELESS, TURNED)
ANSWERS(contrary, !LEAF_02, "1 and 0 are swapped: 1 is a leaf")
ANSWERS(one_failed_more, LOW || FEW || in.n_failed > MAX_FAILED_SPLITS,
        "your answers are those of n_failed > MAX_FAILED_SPLITS: exactly that many are enough")
ANSWERS(without_failed, LOW || FEW, "failed splits were not asked for")
ANSWERS(limits_swapped,
        in.level >= in.targetElementsPerNode || in.n_circles <= (u32)in.maxDepth || HOPELESS,
        "the two limits are in each other's places")
#define TARGET_IGNORED                                                                             \
    "your answers are those of a number of your own: targetElementsPerNode says what is few"
ANSWERS(none_left, LOW || in.n_circles == 0 || HOPELESS, TARGET_IGNORED)
ANSWERS(one_left, LOW || in.n_circles <= 1 || HOPELESS, TARGET_IGNORED)
ANSWERS(failed_added_beyond, in.level + in.n_failed > in.maxDepth || FEW || HOPELESS,
        "your answers are those of a level to which failed splits were added")
ANSWERS(one_failed, LOW || FEW || FAILED(1),
        "one failed split is no reason to stop, only MAX_FAILED_SPLITS are")
ANSWERS(two_failed, LOW || FEW || FAILED(2),
        "two failed splits are no reason to stop, only MAX_FAILED_SPLITS are")
ANSWERS(three_failed, LOW || FEW || FAILED(3),
        "three failed splits are no reason to stop, only MAX_FAILED_SPLITS are")
ANSWERS(failed_added, in.level + in.n_failed >= in.maxDepth || FEW || HOPELESS,
        "your answers are those of a level to which failed splits were added")
ANSWERS(limits_16_8, in.level >= 16 || in.n_circles <= 8 || HOPELESS,
        "your answers are those of limits 16 and 8, whatever limits are given")
ANSWERS(limits_4_1, in.level >= 4 || in.n_circles <= 1 || HOPELESS,
        "your answers are those of limits 4 and 1, whatever limits are given")
ANSWERS(level_in_8_bits, (in.level & 0xff) >= in.maxDepth || FEW || HOPELESS,
        "your answers are those of a level cut to 8 bits")
ANSWERS(count_in_8_bits, LOW || (int)(in.n_circles & 0xff) <= in.targetElementsPerNode || HOPELESS,
        "your answers are those of a count cut to 8 bits")
ANSWERS(count_in_16_bits,
        LOW || (int)(in.n_circles & 0xffff) <= in.targetElementsPerNode || HOPELESS,
        "your answers are those of a count cut to 16 bits")
ANSWERS(signed_count, LOW || (i32)in.n_circles <= in.targetElementsPerNode || HOPELESS,
        "your answers are those of a count with a sign: n_circles has none")

static const Known *const known_of_leaf[] = {
    &just_1_and_0,        &one_level_more,   &one_level_less,  &fewer,
    &without_level,       &without_count,    &level_and_count, &level_and_failed,
    &count_and_failed,    &level_and_rest,   &count_and_rest,  &failed_and_rest,
    &all_three,           &just_level,       &just_count,      &just_failed,
    &level_turned,        &level_below,      &count_turned,    &count_above,
    &failed_turned,       &failed_below,     &contrary,        &limits_swapped,
    &one_failed_more,     &without_failed,   &none_left,       &one_left,
    &failed_added_beyond, &one_failed,       &two_failed,      &three_failed,
    &failed_added,        &limits_16_8,      &limits_4_1,      &level_in_8_bits,
    &count_in_8_bits,     &count_in_16_bits, &signed_count,
};

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

ANSWERS(by_corners, in.maxX >= in.maxY,
        "maxX and maxY were compared: the lengths of the sides count")
ANSWERS(always_x, 1, SHORTER)
ANSWERS(always_y, 0, SHORTER)
ANSWERS(whole_numbers, (int)WIDTH >= (int)HEIGHT, NOT_EQUAL)
EACH(shorter, WIDTH == HEIGHT || IS_FOUND(WIDTH < HEIGHT), SHORTER)
ONLY(none_split, side == SIDE_NONE, "nothing was split, or both sides")
ONLY(equal, side != SIDE_NONE && WIDTH == HEIGHT, "where both sides are equal, x is split")
ONLY(nearly_equal, side != SIDE_NONE && NEARLY_EQUAL, NOT_EQUAL)
ONLY(some_shorter, side != SIDE_NONE && WIDTH != HEIGHT && !NEARLY_EQUAL, SHORTER)

static const Known *const known_of_longer[] = {&by_corners,    &always_x,     &always_y,
                                               &whole_numbers, &shorter,      &none_split,
                                               &equal,         &nearly_equal, &some_shorter};

// Where: along the side that the student has split, be it the right one or not.
#define OWN_SIDE (side != SIDE_NONE ? side : WIDTH >= HEIGHT ? SIDE_X : SIDE_Y)
#define LOW_END (OWN_SIDE == SIDE_X ? in.minX : in.minY)
#define HIGH_END (OWN_SIDE == SIDE_X ? in.maxX : in.maxY)
#define MIDDLE (float)(((double)LOW_END + HIGH_END) / 2)
#define IS_LOWER(half, border) is_part(found[half], in, OWN_SIDE, 0, border)
#define IS_UPPER(half, border) is_part(found[half], in, OWN_SIDE, 1, border)
#undef IS_FOUND
#define IS_FOUND(border) (IS_LOWER(0, border) && IS_UPPER(1, border))

RIGHT(is_middle, IS_FOUND(MIDDLE))

ANSWERS(half_the_width, (HIGH_END - LOW_END) / 2,
        "that is half the width: the cell does not begin at 0")
ANSWERS(half_of_max, HIGH_END / 2, "that is half of the upper border: the cell does not begin at 0")
ANSWERS(behind_max, HIGH_END + (HIGH_END - LOW_END) / 2,
        "half the length was added to the upper border, not to the lower one")
ANSWERS(middle_added, LOW_END + MIDDLE, "the middle was added to the lower border once more")
#define OTHER_MIDDLE "that is the middle of the other side's borders"
ANSWERS(middle_of_x, (float)(((double)in.minX + in.maxX) / 2), OTHER_MIDDLE)
ANSWERS(middle_of_y, (float)(((double)in.minY + in.maxY) / 2), OTHER_MIDDLE)
#define OTHER_LOW "the middle was counted from the lower border of the other side"
ANSWERS(y_from_min_x, OWN_SIDE == SIDE_Y ? in.minX + (HIGH_END - LOW_END) / 2 : MIDDLE, OTHER_LOW)
ANSWERS(x_from_min_y, OWN_SIDE == SIDE_X ? in.minY + (HIGH_END - LOW_END) / 2 : MIDDLE, OTHER_LOW)
#define WHOLE_LENGTH "the length of a side was made a whole number"
ANSWERS(whole_length, LOW_END + truncf(HIGH_END - LOW_END) / 2, WHOLE_LENGTH)
ANSWERS(whole_half, LOW_END + truncf((HIGH_END - LOW_END) / 2), WHOLE_LENGTH)
#define HALF_OF(half_side) (OWN_SIDE == (half_side) ? (HIGH_END - LOW_END) / 2 : MIDDLE)
#define HALF_OF_ONE "that is half the length of one of the two sides: the cell does not begin at 0"
ANSWERS(half_of_x, HALF_OF(SIDE_X), HALF_OF_ONE)
ANSWERS(half_of_y, HALF_OF(SIDE_Y), HALF_OF_ONE)
ANSWERS(cut_to_whole, truncf(MIDDLE), "the middle was made a whole number")
ANSWERS(rounded_down, floorf(MIDDLE), "the middle was made a whole number")
EACH(border_moved, IS_LOWER(0, MIDDLE) && IS_UPPER(1, (LOW_END + MIDDLE) / 2),
     "the second border was computed from the first after that had moved")
ONLY(swapped, IS_LOWER(1, MIDDLE) && IS_UPPER(0, MIDDLE), "left and right are swapped")
ONLY(one_right, IS_LOWER(0, MIDDLE) || IS_UPPER(1, MIDDLE),
     "one half is right and the other is not: both have the border in the middle")

#define OWN_BORDER (OWN_SIDE == SIDE_X ? found[0].maxX : found[0].maxY)
ONLY(elsewhere, side != SIDE_NONE && IS_FOUND(OWN_BORDER),
     "both halves have the same border, and it is not in the middle")

static const Known *const known_of_middle[] = {
    &y_from_min_x, &x_from_min_y, &half_of_max,  &behind_max,     &middle_added, &middle_of_x,
    &middle_of_y,  &whole_length, &whole_half,   &half_the_width, &half_of_x,    &half_of_y,
    &cut_to_whole, &rounded_down, &border_moved, &swapped,        &one_right,    &elsewhere};

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
