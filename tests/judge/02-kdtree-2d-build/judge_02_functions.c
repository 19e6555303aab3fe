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

static int leaf_02(LeafJob in)
{
    const KdTreeLimits limits = {in.maxDepth, in.targetElementsPerNode};
    return oracle_is_leaf(in.level, in.n_circles, in.n_failed, limits);
}

RIGHT(is_right_leaf, IS_FOUND(leaf_02(in)))

#define OTHER_LIMIT "one of the three numbers was compared with what is the limit of another"

KNOWN_LIST(known_of_leaf)
{
    GIVEN;
    const int leaf = leaf_02(in);
    const int low = in.level >= in.maxDepth;
    const int few = in.n_circles <= (u32)in.targetElementsPerNode;
    const int hopeless = in.n_failed >= MAX_FAILED_SPLITS;
    const int64_t n_circles = in.n_circles;

    EACH(just_1_and_0, (found != 0) == leaf, JUST_1_AND_0);
    ANSWERS(one_level_more, in.level > in.maxDepth || few || hopeless,
            "your answers are those of level > maxDepth: a node on level maxDepth is a leaf");
    ANSWERS(one_level_less, in.level + 1 >= in.maxDepth || few || hopeless,
            "your answers are those of a root on level 0: levels count from 1");
    ANSWERS(fewer, low || in.n_circles < (u32)in.targetElementsPerNode || hopeless,
            "your answers are those of n_circles < targetElementsPerNode: exactly that many are "
            "few enough");
    ANSWERS(without_level, few || hopeless, "the level was not asked for");
    ANSWERS(without_count, low || hopeless, "the number of circles was not asked for");
#define BOTH_NEEDED "your answers are those of && between two reasons: one reason is enough"
    ANSWERS(level_and_count, (low && few) || hopeless, BOTH_NEEDED);
    ANSWERS(level_and_failed, (low && hopeless) || few, BOTH_NEEDED);
    ANSWERS(count_and_failed, low || (few && hopeless), BOTH_NEEDED);
    ANSWERS(level_and_rest, low && (few || hopeless), BOTH_NEEDED);
    ANSWERS(count_and_rest, few && (low || hopeless), BOTH_NEEDED);
    ANSWERS(failed_and_rest, hopeless && (low || few), BOTH_NEEDED);
    ANSWERS(all_three, low && few && hopeless, "one of the three reasons is enough, not only all");
#define BEYOND                                                                                     \
    "your answers are those of == with a limit: it counts, and so does everything beyond it"
    ANSWERS(just_level, in.level == in.maxDepth || few || hopeless, BEYOND);
    ANSWERS(just_count, low || in.n_circles == (u32)in.targetElementsPerNode || hopeless, BEYOND);
    ANSWERS(just_failed, low || few || in.n_failed == MAX_FAILED_SPLITS, BEYOND);
#define TURNED "your answers are those of a comparison the wrong way round"
    ANSWERS(level_turned, in.level <= in.maxDepth || few || hopeless, TURNED);
    ANSWERS(level_below, in.level < in.maxDepth || few || hopeless, TURNED);
    ANSWERS(count_turned, low || in.n_circles >= (u32)in.targetElementsPerNode || hopeless, TURNED);
    ANSWERS(count_above, low || !few || hopeless, TURNED);
    ANSWERS(failed_turned, low || few || in.n_failed <= MAX_FAILED_SPLITS, TURNED);
    ANSWERS(failed_below, low || few || !hopeless, TURNED);
    ANSWERS(contrary, !leaf, "1 and 0 are swapped: 1 is a leaf");
    ANSWERS(one_failed_more, low || few || in.n_failed > MAX_FAILED_SPLITS,
            "your answers are those of n_failed > MAX_FAILED_SPLITS: exactly that many are enough");
    ANSWERS(without_failed, low || few,
            "failed splits never make a leaf there: MAX_FAILED_SPLITS of them do");
    ANSWERS(limits_swapped,
            in.level >= in.targetElementsPerNode || in.n_circles <= (u32)in.maxDepth || hopeless,
            "the two limits are in each other's places");
    ANSWERS(level_to_target, in.level >= in.targetElementsPerNode || few || hopeless, OTHER_LIMIT);
    ANSWERS(level_to_failed, in.level >= MAX_FAILED_SPLITS || few || hopeless, OTHER_LIMIT);
    ANSWERS(count_to_depth, low || n_circles <= in.maxDepth || hopeless, OTHER_LIMIT);
    ANSWERS(count_to_failed, low || n_circles <= MAX_FAILED_SPLITS || hopeless, OTHER_LIMIT);
    ANSWERS(count_to_level, low || n_circles <= in.level || hopeless, OTHER_LIMIT);
    ANSWERS(failed_to_target, low || few || in.n_failed >= in.targetElementsPerNode, OTHER_LIMIT);
    ANSWERS(failed_to_level, low || few || in.n_failed >= in.level, OTHER_LIMIT);
    ANSWERS(one_circle_more, low || n_circles <= 1LL + in.targetElementsPerNode || hopeless,
            "one circle more than targetElementsPerNode is not few enough");

#define TARGET_IGNORED                                                                             \
    "your answers are those of a number of your own: targetElementsPerNode says what is few"
    ANSWERS(none_left, low || in.n_circles == 0 || hopeless, TARGET_IGNORED);
    ANSWERS(one_left, low || in.n_circles <= 1 || hopeless, TARGET_IGNORED);
    ANSWERS(failed_added_beyond, in.level + in.n_failed > in.maxDepth || few || hopeless,
            "your answers are those of a level to which failed splits were added");
    ANSWERS(one_failed, low || few || in.n_failed >= 1,
            "one failed split is no reason to stop, only MAX_FAILED_SPLITS are");
    ANSWERS(two_failed, low || few || in.n_failed >= 2,
            "two failed splits are no reason to stop, only MAX_FAILED_SPLITS are");
    ANSWERS(three_failed, low || few || in.n_failed >= 3,
            "three failed splits are no reason to stop, only MAX_FAILED_SPLITS are");
    ANSWERS(failed_added, in.level + in.n_failed >= in.maxDepth || few || hopeless,
            "your answers are those of a level to which failed splits were added");
    ANSWERS(limits_16_8, in.level >= 16 || in.n_circles <= 8 || hopeless,
            "your answers are those of limits 16 and 8, whatever limits are given");
    ANSWERS(limits_4_1, in.level >= 4 || in.n_circles <= 1 || hopeless,
            "your answers are those of limits 4 and 1, whatever limits are given");
    ANSWERS(level_in_8_bits, (in.level & 0xff) >= in.maxDepth || few || hopeless,
            "your answers are those of a level cut to 8 bits");
    ANSWERS(count_in_8_bits,
            low || (int)(in.n_circles & 0xff) <= in.targetElementsPerNode || hopeless,
            "your answers are those of a count cut to 8 bits");
    ANSWERS(count_in_16_bits,
            low || (int)(in.n_circles & 0xffff) <= in.targetElementsPerNode || hopeless,
            "your answers are those of a count cut to 16 bits");
    ANSWERS(signed_count, low || (i32)in.n_circles <= in.targetElementsPerNode || hopeless,
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
                       leaf_02(in));
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
    const double width = (double)in.maxX - in.minX, height = (double)in.maxY - in.minY;            \
    (void)side, (void)width, (void)height

// Which side: the longer one. Across a side of no length nothing is seen of a split.
#define IS_FOUND(x_is_split)                                                                       \
    ((x_is_split) ? side == SIDE_X || (width == 0 && side == SIDE_NONE)                            \
                  : side == SIDE_Y || (height == 0 && side == SIDE_NONE))

RIGHT(is_longer, IS_FOUND(width >= height))

#define SHORTER "the shorter side was split"
#define NOT_EQUAL "the sides are not equal, if nearly: the longer one is split"

KNOWN_LIST(known_of_longer)
{
    GIVEN;
    const int is_nearly_equal =
        width != height && height - width < height / 1024 && width - height < width / 1024;

#define WRONG_SIDE "a side was computed wrongly: it is its own maximum minus its own minimum"
    ANSWERS(sum_of_x, (double)in.maxX + in.minX >= height, WRONG_SIDE);
    ANSWERS(sum_of_y, width >= (double)in.maxY + in.minY, WRONG_SIDE);
    ANSWERS(sums, (double)in.maxX + in.minX >= (double)in.maxY + in.minY, WRONG_SIDE);
    ANSWERS(x_is_max, in.maxX >= height, WRONG_SIDE);
    ANSWERS(y_is_max, width >= in.maxY, WRONG_SIDE);
    // So are a width that begins at minY, and a height that begins at minX, or ends at the other's
    // end.
    ANSWERS(by_corners, in.maxX >= in.maxY,
            "your answers are those of maxX against maxY: the lengths of the sides count");
    ANSWERS(by_low_corners, in.minX <= in.minY,
            "your answers are those of minX against minY: the lengths of the sides count");
    ANSWERS(always_x, 1, SHORTER);
    ANSWERS(always_y, 0, SHORTER);
    ANSWERS(whole_numbers, (int)width >= (int)height, NOT_EQUAL);
    EACH(shorter, width == height || IS_FOUND(width < height), SHORTER);
    ONLY(none_split, side == SIDE_NONE, "nothing was split, or both sides");
    ONLY(equal, side != SIDE_NONE && width == height, "where both sides are equal, x is split");
    ONLY(nearly_equal, side != SIDE_NONE && is_nearly_equal, NOT_EQUAL);
    ONLY(some_shorter, side != SIDE_NONE && width != height && !is_nearly_equal, SHORTER);
    return NO_MORE;
}

// Where: along the side that the student has split, be it the right one or not. Across a side of no
// length nothing is seen of a split.
static Side own_side(BBox2D in, Side split)
{
    const double width = (double)in.maxX - in.minX, height = (double)in.maxY - in.minY;
    return split != SIDE_NONE ? split
           : width == 0       ? SIDE_X
           : height == 0      ? SIDE_Y
           : width >= height  ? SIDE_X
                              : SIDE_Y;
}

static float low_end(BBox2D in, Side side)
{
    return side == SIDE_X ? in.minX : in.minY;
}

static float high_end(BBox2D in, Side side)
{
    return side == SIDE_X ? in.maxX : in.maxY;
}

static float middle_of(BBox2D in, Side side)
{
    return (float)(((double)low_end(in, side) + high_end(in, side)) / 2);
}

#undef IS_FOUND
#define IS_FOUND(border) is_split_at(found, in, own_side(in, side), border)

RIGHT(is_middle, IS_FOUND(middle_of(in, own_side(in, side))))

// Wrong on both sides, or on one of them.
#define BORDER(name, border, ...)                                                                  \
    ANSWERS(name, border, __VA_ARGS__);                                                            \
    ANSWERS(name##_of_x, own == SIDE_X ? (border) : middle, __VA_ARGS__);                          \
    ANSWERS(name##_of_y, own == SIDE_Y ? (border) : middle, __VA_ARGS__)
KNOWN_LIST(known_of_middle)
{
    GIVEN;
    const Side own = own_side(in, side), other = own == SIDE_X ? SIDE_Y : SIDE_X;
    const float low = low_end(in, own), high = high_end(in, own), length = high - low;
    const float other_low = low_end(in, other), other_high = high_end(in, other);
    const float middle = middle_of(in, own), border_found = high_end(found[0], own);

    BORDER(half_the_length, length / 2, "that is half of a length: the cell does not begin at 0");
    BORDER(half_of_max, high / 2, "that is half of the upper border: the cell does not begin at 0");
    BORDER(behind_max, high + length / 2,
           "half the length was added to the upper border, not to the lower one");
    BORDER(before_min, low - length / 2,
           "half the length was taken off the lower border: it is to be added");
    BORDER(middle_added, low + middle, "the middle was added to the lower border once more");
    BORDER(not_halved, high, "the whole length was added to the lower border, not half of it");
    BORDER(sum_not_halved, low + high, "the sum of the borders was not halved");
    BORDER(doubled, low + length * 2, "the length was doubled, not halved");
    BORDER(other_middle, (float)(((double)other_low + other_high) / 2),
           "that is the middle of the other side's borders");
    BORDER(from_other_low, other_low + length / 2,
           "the middle was counted from the lower border of the other side");
#define OTHER_LENGTH "half the length of the other side was added"
    BORDER(other_length, low + (other_high - other_low) / 2, OTHER_LENGTH);
#define MIXED_LENGTH "a length was computed wrongly: it is a maximum minus the minimum of that side"
    BORDER(length_from_other_low, low + (high - other_low) / 2, MIXED_LENGTH);
    BORDER(length_to_other_high, low + (other_high - low) / 2, MIXED_LENGTH);
#define WHOLE_LENGTH "the length of a side was made a whole number"
    BORDER(whole_length, low + truncf(length) / 2, WHOLE_LENGTH);
    BORDER(whole_half, low + truncf(length / 2), WHOLE_LENGTH);
#define WHOLE_MIDDLE "the middle was made a whole number"
    BORDER(cut_to_whole, truncf(middle), WHOLE_MIDDLE);
    BORDER(rounded_down, floorf(middle), WHOLE_MIDDLE);
    EACH(border_moved,
         is_part(found[0], in, own, 0, middle) && is_part(found[1], in, own, 1, (low + middle) / 2),
         "the second border was computed from the first after that had moved");
    ONLY(swapped, is_part(found[1], in, own, 0, middle) && is_part(found[0], in, own, 1, middle),
         "left and right are swapped");
    ONLY(both_moved,
         low_end(found[0], own) == high_end(found[0], own) ||
             low_end(found[1], own) == high_end(found[1], own),
         "both borders of a half are the same: of each half the split moves one");
    ONLY(one_right, is_part(found[0], in, own, 0, middle) || is_part(found[1], in, own, 1, middle),
         "one half is right and the other is not: both have the border in the middle");
    ONLY(elsewhere, side != SIDE_NONE && IS_FOUND(border_found),
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
    const Side own = own_side(in, side);
    *(own == SIDE_X ? &left.maxX : &left.maxY) = middle_of(in, own);
    return describe_split(in, found, left);
}

const Function split_longer_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  KNOWING(is_longer, describe_longer, known_of_longer)};
const Function split_middle_02 = {"splits", N_SPLITS, 2 * sizeof(BBox2D),
                                  KNOWING(is_middle, describe_middle, known_of_middle)};
