// Lab 06: choose_split, sphere_overlaps_box and fits_todo on the job's inputs. See judge_06.h;
// judge_06_packs.c is the sibling.
#include "judge_06.h"

#include "message.h"
#include "overlap_reach.h"
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

#define LENGTH(axis) ((double)in.max[axis] - in.min[axis])
#define OWN_LENGTH LENGTH(found.axis)
#define LONGEST fmax(LENGTH(0), fmax(LENGTH(1), LENGTH(2)))
#define SHORTEST fmin(LENGTH(0), fmin(LENGTH(1), LENGTH(2)))
#define AXIS_OF_LARGEST(x, y, z) ((z) > fmax(x, y) ? 2u : (y) > (x) ? 1u : 0u)
#define NOT_THE_LONGEST                                                                            \
    "each side was compared with one other only: the longest so far has to be remembered"

ANSWERS(beside_x, LENGTH(2) > LENGTH(0) ? 2u : LENGTH(1) > LENGTH(0) ? 1u : 0u, NOT_THE_LONGEST)
ANSWERS(beside_last, LENGTH(2) > LENGTH(1) ? 2u : LENGTH(1) > LENGTH(0) ? 1u : 0u, NOT_THE_LONGEST)
ANSWERS(whole_lengths, AXIS_OF_LARGEST(trunc(LENGTH(0)), trunc(LENGTH(1)), trunc(LENGTH(2))),
        "the sides were compared as whole numbers")
ANSWERS(largest, AXIS_OF_LARGEST(in.max[0], in.max[1], in.max[2]),
        "that is the axis of the largest coordinate, not of the longest side")
ANSWERS(always_x, 0u, "x was split every time: the longest side is to be split")
ANSWERS(never_z, LENGTH(1) > LENGTH(0) ? 1u : 0u, "z was never split, and a cell has three sides")
ONLY(no_axis, found.axis >= 3, "there are axes 0, 1 and 2")
ONLY(equal, found.axis < 3 && OWN_LENGTH == LONGEST, "of equal sides the first counts")
ONLY(nearly_equal, found.axis < 3 && LONGEST - OWN_LENGTH < LONGEST / 1024,
     "these sides are not equal, if nearly, and the longest is split")
ONLY(shortest, found.axis < 3 && OWN_LENGTH == SHORTEST, "that side is the shortest")

static const Known *const known_of_axis[] = {
    &beside_x, &beside_last, &whole_lengths, &largest,      &always_x,
    &never_z,  &no_axis,     &equal,         &nearly_equal, &shortest,
};

const Function split_axis_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                KNOWING(is_longest, describe_axis, known_of_axis)};
#undef IS_FOUND

// Where along the side that the student has chosen. An axis that is none is the other check's
// matter.
#define OWN_AXIS (found.axis < 3 ? found.axis : 0)
#define LOW_END ((double)in.min[OWN_AXIS])
#define HIGH_END ((double)in.max[OWN_AXIS])
#define IS_FOUND(at) (fabs(found.pos - (at)) <= FLT_EPSILON * 4096)

static char *describe_middle(const void *job, int i, const void *answers)
{
    GIVEN;
    return facts_of(tree3d_judge_middle("choose_split", in, OWN_AXIS, found.pos));
}

RIGHT(is_middle, facts_are_none(describe_middle(job, i, answers)))

ANSWERS(zero_for_a_point, HIGH_END > LOW_END ? (LOW_END + HIGH_END) / 2 : 0,
        "other cells are right, but one of no length has its middle where it lies, too")
ANSWERS(whole_middle, floor((LOW_END + HIGH_END) / 2), "the middle was rounded to a whole number")
ANSWERS(middle_of_x, ((double)in.min[0] + in.max[0]) / 2,
        "the position is the middle of x, whatever the axis")
ANSWERS(sum_of_ends, LOW_END + HIGH_END, "the sum of both ends is to be halved")
ANSWERS(half_length, (HIGH_END - LOW_END) / 2, "that is half the length, as if the cell began at 0")

static const Known *const known_of_middle[] = {&zero_for_a_point, &whole_middle, &middle_of_x,
                                               &sum_of_ends, &half_length};

const Function split_middle_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                  KNOWING(is_middle, describe_middle, known_of_middle)};
#undef GIVEN
#undef IS_FOUND

// ---- sphere_overlaps_box ------------------------------------------------------------------------

static Reach reach_of(SphereBoxJob in)
{
    return (Reach){{outside_of(in.sphere.x, in.box.min[0], in.box.max[0]),
                    outside_of(in.sphere.y, in.box.min[1], in.box.max[1]),
                    outside_of(in.sphere.z, in.box.min[2], in.box.max[2])},
                   in.sphere.radius};
}

#define GIVEN                                                                                      \
    const SphereBoxJob in = ((const Job06 *)job)->overlaps[i];                                     \
    const Reach reach = reach_of(in);                                                              \
    const int found = ((const i32 *)answers)[i];                                                   \
    (void)reach
#define IS_FOUND(expected) ((found != 0) == (expected))

#include "overlap_known.h"

static int is_right_overlap(const void *job, int i, const void *answers)
{
    GIVEN;
    const SphereInCell is = tree3d_judge_sphere(in.sphere, in.box);
    return is == SPHERE_EITHER || IS_FOUND(is == SPHERE_INSIDE);
}

// How far the cell's nearer, or farther, end lies from the centre on an axis.
static double to_end(SphereBoxJob in, int axis, int is_farther)
{
    const double centre[3] = {in.sphere.x, in.sphere.y, in.sphere.z};
    const double to_min = fabs(centre[axis] - in.box.min[axis]);
    const double to_max = fabs(centre[axis] - in.box.max[axis]);
    return (to_min > to_max) == is_farther ? to_min : to_max;
}

// Does the sphere hold the cell's nearest corner, or its farthest, and so all of it?
static int holds_corner(SphereBoxJob in, int is_farthest)
{
    const double x = to_end(in, 0, is_farthest), y = to_end(in, 1, is_farthest),
                 z = to_end(in, 2, is_farthest);
    return x * x + y * y + z * z <= (double)in.sphere.radius * in.sphere.radius;
}

ANSWERS(by_signed_root, sqrt(D2) <= RADIUS,
        "a negative radius counts as its absolute value; and the root is rounded: compare squares")

static double to_middle(double value, float min, float max)
{
    return value - ((double)min + max) / 2;
}

static int holds_middle(SphereBoxJob in)
{
    const double x = to_middle(in.sphere.x, in.box.min[0], in.box.max[0]),
                 y = to_middle(in.sphere.y, in.box.min[1], in.box.max[1]),
                 z = to_middle(in.sphere.z, in.box.min[2], in.box.max[2]);
    return x * x + y * y + z * z <= (double)in.sphere.radius * in.sphere.radius;
}

ANSWERS(by_middle, holds_middle(in),
        "your answers are those of the cell's middle, and another point may be nearer")
EACH(cube, IS_OF_BOX, "the sphere's bounding cube overlaps, the sphere does not")
ONLY(cell_within, !found && holds_corner(in, 1),
     "a cell that lies within the sphere overlaps it, too: both have their insides")
ONLY(centre_within, !found && reach_furthest(reach) == 0,
     "a sphere whose centre is in the cell overlaps it")
ONLY(no_corner, !found && !holds_corner(in, 0),
     "what is missed holds no corner of the cell: a sphere may come in through a side or over an "
     "edge")
ONLY(reaches_in, !found && reach_furthest(reach) > 0,
     "its centre is outside but the sphere reaches in")

static const Known *const known_of_overlap[] = {&by_signed_root, &by_middle,   &cube,
                                                OVERLAP_KNOWN,   &cell_within, &centre_within,
                                                &no_corner,      &reaches_in};

static char *describe_overlap(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("sphere at %s, box %s: found %d, expected %d", words_sphere(in.sphere).text,
                       words_box3d(in.box).text, found,
                       tree3d_judge_sphere(in.sphere, in.box) == SPHERE_INSIDE);
}

const Function overlap_06 = {"overlaps", N_OVERLAPS, sizeof(i32),
                             KNOWING(is_right_overlap, describe_overlap, known_of_overlap),
                             .knows_constant = 1};
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

#define LAST last_allowed(answers)
ANSWERS(one_short, in <= TODO_SIZE - 1,
        "the last place of the stack is never used: a split on level N lets N nodes wait, and as "
        "many as there are places fit")
ANSWERS(one_too_many, in <= TODO_SIZE + 1,
        "that is one level too many: a split on level N lets N nodes wait, not N - 1")
ANSWERS(half, in <= TODO_SIZE / 2, "only one node waits for each split, not two")
ANSWERS(nodes_of_level, in <= 5,
        "a level's nodes were counted: of all of them only one waits for each split on the way")
ANSWERS(inverted, in > TODO_SIZE, "1 and 0 are swapped: 1 allows the split")
ANSWERS(always, 1, "every split is allowed: the stack has TODO_SIZE places")
ANSWERS(never, 0, "no split is allowed: the stack has TODO_SIZE places")
ANSWERS(only_last, in == TODO_SIZE,
        "each level up to the last that fits is allowed, not that alone")
#define LEVEL_CUT                                                                                  \
    "the level was cut to 8 or 16 bits: it is an int, and any level beyond TODO_SIZE is too deep"
ANSWERS(cut_u8, (uint8_t)in <= TODO_SIZE, LEVEL_CUT)
ANSWERS(cut_i8, (int8_t)in <= TODO_SIZE, LEVEL_CUT)
ANSWERS(cut_u16, (uint16_t)in <= TODO_SIZE, LEVEL_CUT)
ANSWERS(cut_i16, (int16_t)in <= TODO_SIZE, LEVEL_CUT)
// Of which of the others it is.
ONLY(other_limit, LAST != TODO_SIZE && is_limit(job, answers, LAST),
     "levels are compared with another number than TODO_SIZE")
ONLY(too_few, in <= TODO_SIZE, "levels are refused though as many nodes as they let wait fit")
ONLY(far_beyond, in > TODO_SIZE,
     "only levels beyond TODO_SIZE are wrong: all of them are too deep, however large the number")

static const Known *const known_of_levels[] = {
    &one_short, &one_too_many, &half,           &inverted, &always,
    &never,     &only_last,    &nodes_of_level, &cut_u8,   &cut_i8,
    &cut_u16,   &cut_i16,      &other_limit,    &too_few,  &far_beyond};

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
