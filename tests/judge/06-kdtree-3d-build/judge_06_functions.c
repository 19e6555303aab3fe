// Lab 06: choose_split and fits_todo on the job's inputs. See judge_06.h; judge_06_overlap.c and
// judge_06_packs.c are the siblings.
#include "judge_06.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <stdlib.h>

static char *facts_of(Diagnosis wrong)
{
    free(wrong.cause);
    return wrong.found;
}

// ---- choose_split -------------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const BBox3D in = ((const Job06 *)job)->splits[i];                                             \
    const SplitAnswer3D found = ((const SplitAnswer3D *)answers)[i]
#define IS_FOUND(expected) (found.axis == (expected))

static char *describe_axis(const void *job, int i, const void *answers)
{
    GIVEN;
    return facts_of(tree3d_judge_axis("choose_split", in, found.axis));
}

RIGHT(is_longest, facts_are_none(describe_axis(job, i, answers)))

static double length_of(BBox3D in, u32 axis)
{
    return (double)in.max[axis] - in.min[axis];
}

static double middle_on(BBox3D in, u32 axis)
{
    return ((double)in.min[axis] + in.max[axis]) / 2;
}

static double farthest(BBox3D in, u32 axis)
{
    return fmax(fabs((double)in.min[axis]), fabs((double)in.max[axis]));
}

static u32 axis_of_largest(double x, double y, double z)
{
    return z > fmax(x, y) ? 2 : y > x ? 1 : 0;
}

#define NOT_THE_LONGEST                                                                            \
    "each side was compared with one other only: the longest so far has to be remembered"

KNOWN_LIST(known_of_axis)
{
    GIVEN;
    const double x = length_of(in, 0), y = length_of(in, 1), z = length_of(in, 2);
    const double longest = fmax(x, fmax(y, z)), shortest_side = fmin(x, fmin(y, z));
    const double own = found.axis < 3 ? length_of(in, found.axis) : 0;

    ANSWERS(beside_x, z > x ? 2u : y > x ? 1u : 0u, NOT_THE_LONGEST);
    ANSWERS(beside_last, z > y ? 2u : y > x ? 1u : 0u, NOT_THE_LONGEST);
    ANSWERS(whole_lengths, axis_of_largest(trunc(x), trunc(y), trunc(z)),
            "the sides were compared as whole numbers");
    ANSWERS(largest, axis_of_largest(in.max[0], in.max[1], in.max[2]),
            "that is the axis of the largest coordinate, not of the longest side");
    ANSWERS(beside_next, x > y ? 0u : y > z ? 1u : 2u, NOT_THE_LONGEST);
    ANSWERS(beside_next_equal, x >= y ? 0u : y >= z ? 1u : 2u, NOT_THE_LONGEST);
    ANSWERS(last_where_equal,
            x > fmax(y, z)   ? 0u
            : y > fmax(x, z) ? 1u
                             : 2u,
            "where sides are equal no comparison is true, and z is left: of equal sides the first "
            "counts");
    ANSWERS(last_of_any_length,
            z > 0   ? 2u
            : y > 0 ? 1u
                    : 0u,
            "the longest so far was not kept: each side was compared with what it was at first");
    ANSWERS(largest_end, axis_of_largest(farthest(in, 0), farthest(in, 1), farthest(in, 2)),
            "that is the axis of the largest coordinate, not of the longest side");
    ANSWERS(largest_sum, axis_of_largest(middle_on(in, 0), middle_on(in, 1), middle_on(in, 2)),
            "minimum and maximum were added: a side is the maximum minus the minimum");
    ANSWERS(always_y, 1u, "y was split every time: the longest side is to be split");
    ANSWERS(always_z, 2u, "z was split every time: the longest side is to be split");
    ANSWERS(always_x, 0u, "x was split every time: the longest side is to be split");
    ANSWERS(never_y, z > x ? 2u : 0u, "y was never split, and a cell has three sides");
    ANSWERS(never_x, z > y ? 2u : 1u, "x was never split, and a cell has three sides");
    ANSWERS(never_z, y > x ? 1u : 0u, "z was never split, and a cell has three sides");
    ONLY(no_axis, found.axis >= 3, "there are axes 0, 1 and 2");
    ONLY(equal, found.axis < 3 && own == longest, "of equal sides the first counts");
    ONLY(nearly_equal, found.axis < 3 && own < longest && longest - own < longest / 1024,
         "these sides are not equal, if nearly, and the longest is split");
    ONLY(shortest, found.axis < 3 && own == shortest_side, "that side is the shortest");
    ONLY(nearly_equal_in_whole, found.axis < 3 && longest - own < 2,
         "only sides that differ by less than 2, or not at all, are mistaken for one another: are "
         "they cut to whole numbers, or compared with an epsilon?");
    return NO_MORE;
}

const Function split_axis_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                KNOWING(is_longest, describe_axis, known_of_axis)};
#undef IS_FOUND

// Where along the side that the student has chosen. An axis that is none is the other check's
// matter.
static u32 own_axis(SplitAnswer3D found)
{
    return found.axis < 3 ? found.axis : 0;
}

#define AN_END "that is an end of the side, not its middle"
#define MIN_HALVED "only the minimum was halved: the sum of both ends is to be"
#define WRONG_END "half of the side goes from the minimum up, or from the maximum down"
#define IS_FOUND(at) (fabs(found.pos - (at)) <= FLT_EPSILON * 4096)

static char *describe_middle(const void *job, int i, const void *answers)
{
    GIVEN;
    return facts_of(tree3d_judge_middle("choose_split", in, own_axis(found), found.pos));
}

RIGHT(is_middle, facts_are_none(describe_middle(job, i, answers)))

// A third, a quarter, ...: the same of each side.
static double share_of(BBox3D in, SplitAnswer3D found)
{
    const u32 axis = own_axis(found);
    const double length = length_of(in, axis);
    return length > 0 ? (found.pos - (double)in.min[axis]) / length : 0;
}

static double at_share(const void *job, BBox3D in, SplitAnswer3D found, const void *answers)
{
    const u32 axis = own_axis(found);
    const double share =
        share_of(((const Job06 *)job)->splits[0], ((const SplitAnswer3D *)answers)[0]);
    return in.min[axis] + share * length_of(in, axis);
}

KNOWN_LIST(known_of_middle)
{
    GIVEN;
    const u32 axis = own_axis(found);
    const double low = in.min[axis], high = in.max[axis], length = high - low;

    ANSWERS(zero_for_a_point, high > low ? (low + high) / 2 : 0,
            "other cells are right, but one of no length has its middle where it lies, too");
    ANSWERS(whole_middle, floor((low + high) / 2), "the middle was rounded to a whole number");
    ANSWERS(half_of_max, high / 2, "that is half of the maximum: the minimum counts, too");
    ANSWERS(half_of_min, low / 2, "that is half of the minimum: the maximum counts, too");
    ANSWERS(low_end, low, AN_END);
    ANSWERS(high_end, high, AN_END);
    ANSWERS(whole_side, length, "that is the side's length, not a place on it");
    ANSWERS(min_taken_off, length / 2 - low,
            "the minimum is added to half of the side, not taken off");
    ANSWERS(from_max, high + length / 2, WRONG_END);
    ANSWERS(from_min, low - length / 2, WRONG_END);
    ANSWERS(max_halved, low + high / 2,
            "only the maximum was halved: the sum of both ends is to be");
    ANSWERS(min_halved, high - low / 2, MIN_HALVED);
    ANSWERS(min_halved_added, high + low / 2, MIN_HALVED);
    ONLY(other_axis,
         IS_FOUND(middle_on(in, (axis + 1) % 3)) || IS_FOUND(middle_on(in, (axis + 2) % 3)),
         "that is the middle of another axis than split.axis");

    ONLY(other_share, fabs(found.pos - at_share(job, in, found, answers)) <= FLT_EPSILON * 4096,
         "each side is cut at the same share of it, which is not one half");
    ANSWERS(middle_of_y, middle_on(in, 1), "the position is the middle of y, whatever the axis");
    ANSWERS(middle_of_z, middle_on(in, 2), "the position is the middle of z, whatever the axis");
    ANSWERS(middle_of_x, middle_on(in, 0), "the position is the middle of x, whatever the axis");
    ANSWERS(pos_not_set, 0, "split.pos is not set");
    ANY(other_start, 3, IS_FOUND(in.min[way] + length / 2),
        "half of the side was added to the minimum of the same axis each time: it is that of "
        "split.axis");
    ANY(whole_length, 2, IS_FOUND(low + (way ? trunc(length / 2) : trunc(length) / 2)),
        "the side's length, or half of it, was made a whole number");
    ANSWERS(sum_halved_added, low + (low + high) / 2,
            "from the minimum on it is half of the length, not half of the sum of both ends");
    ANSWERS(sum_of_ends, low + high, "the sum of both ends is to be halved");
    ANSWERS(half_length, length / 2, "that is half the length, as if the cell began at 0");
    return NO_MORE;
}

const Function split_middle_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                  KNOWING(is_middle, describe_middle, known_of_middle)};
#undef GIVEN
#undef IS_FOUND

// ---- fits_todo ----------------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const i32 in = (i32)((const Job06 *)job)->levels[i];                                           \
    const int found = ((const i32 *)answers)[i]
#define IS_FOUND(expected) ((found != 0) == (expected))

RIGHT(is_right_level, IS_FOUND(in <= TODO_SIZE))

// Is every level up to `last` allowed, and no other? Then the limit was taken for another number.
static int is_limit(const void *job, const void *answers, i32 last)
{
    int i = 0;
    for (int fits = 1; fits && i < N_LEVELS; i += fits) {
        GIVEN;
        fits = IS_FOUND(in <= last);
    }
    return i == N_LEVELS;
}

// Of the levels in order the last one that is allowed; 0 for none.
static i32 last_allowed(const void *answers)
{
    i32 level = N_LEVELS_IN_ORDER;
    while (level > 0 && ((const i32 *)answers)[level - 1] == 0) {
        level--;
    }
    return level;
}

KNOWN_LIST(known_of_levels)
{
    GIVEN;
    const i32 last = last_allowed(answers);

    ANSWERS(one_short, in <= TODO_SIZE - 1,
            "the last place of the stack is never used: a split on level N lets N nodes wait, and "
            "as many as there are places fit");
    ANSWERS(one_too_many, in <= TODO_SIZE + 1,
            "that is one level too many: a split on level N lets N nodes wait, not N - 1");
    ANSWERS(half, in <= TODO_SIZE / 2, "only one node waits for each split, not two");
    ANSWERS(
        nodes_of_level, in <= 5,
        "a level's nodes were counted: of all of them only one waits for each split on the way");
    ANY(levels_inverted, 2, IS_FOUND(in > TODO_SIZE - way),
        "1 and 0 are swapped: 1 allows the split");
    ANSWERS(all_levels, 1, "every split is allowed: the stack has TODO_SIZE places");
    ANSWERS(not_equal, in != TODO_SIZE,
            "a negative number is not 0, and so counts as yes: return a comparison");
    ANSWERS(no_level, 0, "no split is allowed: the stack has TODO_SIZE places");
    ANSWERS(only_last, in == TODO_SIZE,
            "each level up to the last that fits is allowed, not that alone");
#define LEVEL_CUT                                                                                  \
    "the level was cut to 8 or 16 bits: it is an int, and any level beyond TODO_SIZE is too deep"
    ANSWERS(cut_u8, (uint8_t)in <= TODO_SIZE, LEVEL_CUT);
    ANSWERS(cut_i8, (int8_t)in <= TODO_SIZE, LEVEL_CUT);
    ANSWERS(cut_u16, (uint16_t)in <= TODO_SIZE, LEVEL_CUT);
    ANSWERS(cut_i16, (int16_t)in <= TODO_SIZE, LEVEL_CUT);
    // Of which of the others it is.
    ONLY(other_limit, last != TODO_SIZE && is_limit(job, answers, last),
         "levels are compared with another number than TODO_SIZE");
    ONLY(too_few, in <= TODO_SIZE, "levels are refused though as many nodes as they let wait fit");
    ONLY(far_beyond, in > TODO_SIZE,
         "only levels beyond TODO_SIZE are wrong: all of them are too deep, however large the "
         "number");
    return NO_MORE;
}

static char *describe_level(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("level %d: found %d, expected %d: splitting there leaves up to %d nodes "
                       "waiting, and TODO_SIZE is %d",
                       in, found, in <= TODO_SIZE, in, TODO_SIZE);
}

const Function fits_06 = {"todo",
                          N_LEVELS,
                          sizeof(i32),
                          KNOWING(is_right_level, describe_level, known_of_levels),
                          .counted = "levels",
                          .knows_constant = 1};
