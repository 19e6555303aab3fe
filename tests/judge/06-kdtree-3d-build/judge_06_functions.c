// Lab 06: choose_split, sphere_overlaps_box and fits_todo on the job's inputs. See judge_06.h;
// judge_06_packs.c is the sibling.
#include "judge_06.h"

#include "message.h"
#include "overlap_reach.h"
#include "words.h"

#include <float.h>
#include <math.h>

// ---- choose_split -------------------------------------------------------------------------------

// What an answer with a mistake returns for a cell; the position is on the axis that it chose.
typedef u32 MistakenAxis(BBox3D cell);
typedef double MistakenMiddle(BBox3D cell, u32 axis);

static u32 axis_by_whole_numbers(BBox3D cell)
{
    u32 longest = 0;
    for (u32 axis = 1; axis < 3; axis++) {
        if ((int)(cell.max[axis] - cell.min[axis]) > (int)(cell.max[longest] - cell.min[longest])) {
            longest = axis;
        }
    }
    return longest;
}

static u32 axis_by_largest(BBox3D cell)
{
    const u32 first = cell.max[1] > cell.max[0] ? 1 : 0;
    return cell.max[2] > cell.max[first] ? 2 : first;
}

static double side_length(BBox3D cell, u32 axis)
{
    return (double)cell.max[axis] - cell.min[axis];
}

// The last one that is longer than x.
static u32 axis_beside_x(BBox3D cell)
{
    return side_length(cell, 2) > side_length(cell, 0)   ? 2
           : side_length(cell, 1) > side_length(cell, 0) ? 1
                                                         : 0;
}

// Each compared with the one before it only.
static u32 axis_beside_last(BBox3D cell)
{
    return side_length(cell, 2) > side_length(cell, 1)   ? 2
           : side_length(cell, 1) > side_length(cell, 0) ? 1
                                                         : 0;
}

#define NOT_THE_LONGEST                                                                            \
    "each side was compared with one other only: the longest so far has to be remembered"

static const struct {
    MistakenAxis *axis;
    const char *says;
} axis_mistakes[] = {
    {axis_beside_x, NOT_THE_LONGEST},
    {axis_beside_last, NOT_THE_LONGEST},
    {axis_by_whole_numbers, "the sides were compared as whole numbers"},
    {axis_by_largest, "that is the axis of the largest coordinate, not of the longest side"},
};

static double middle_in_whole_numbers(BBox3D cell, u32 axis)
{
    return floor(((double)cell.min[axis] + cell.max[axis]) / 2);
}

static double middle_of_x(BBox3D cell, u32 axis)
{
    (void)axis;
    return ((double)cell.min[0] + cell.max[0]) / 2;
}

static double sum_of_ends(BBox3D cell, u32 axis)
{
    return (double)cell.min[axis] + cell.max[axis];
}

static double zero_for_a_point(BBox3D cell, u32 axis)
{
    return cell.max[axis] > cell.min[axis] ? ((double)cell.min[axis] + cell.max[axis]) / 2 : 0;
}

static const struct {
    MistakenMiddle *middle;
    const char *says;
} middle_mistakes[] = {
    {zero_for_a_point, "other cells are right, but one of no length has its middle where it lies, "
                       "too"},
    {middle_in_whole_numbers, "the middle was rounded to a whole number"},
    {middle_of_x, "the position is the middle of x, whatever the axis"},
    {sum_of_ends, "the sum of both ends is to be halved"},
};

// The mistake that explains all answers, or NULL.
static const char *axes_look(const Job06 *job, const SplitAnswer3D *found)
{
    for (int m = 0; m < COUNT(axis_mistakes); m++) {
        int i = 0;
        while (i < N_SPLITS && found[i].axis == axis_mistakes[m].axis(job->splits[i])) {
            i++;
        }
        if (i == N_SPLITS) {
            return axis_mistakes[m].says;
        }
    }
    return NULL;
}

static const char *middles_look(const Job06 *job, const SplitAnswer3D *found)
{
    for (int m = 0; m < COUNT(middle_mistakes); m++) {
        int i = 0;
        while (i < N_SPLITS && found[i].axis < 3 &&
               fabs(found[i].pos - middle_mistakes[m].middle(job->splits[i], found[i].axis)) <=
                   FLT_EPSILON * 4096) {
            i++;
        }
        if (i == N_SPLITS) {
            return middle_mistakes[m].says;
        }
    }
    return NULL;
}

static Diagnosis split_axis_fault(const void *job, int i, const void *answers)
{
    const SplitAnswer3D *found = answers;
    const Diagnosis wrong =
        tree3d_judge_axis("choose_split", ((const Job06 *)job)->splits[i], found[i].axis);
    return explained_06(wrong, wrong.found != NULL ? axes_look(job, found) : NULL);
}

// Where along the side that the student has chosen. An axis that is none is the other check's
// matter.
static Diagnosis split_middle_fault(const void *job, int i, const void *answers)
{
    const SplitAnswer3D *found = answers;
    const Diagnosis wrong =
        tree3d_judge_middle("choose_split", ((const Job06 *)job)->splits[i],
                            found[i].axis < 3 ? found[i].axis : 0, found[i].pos);
    return explained_06(wrong, wrong.found != NULL ? middles_look(job, found) : NULL);
}

const Function split_axis_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                .fault = split_axis_fault};
const Function split_middle_06 = {"splits", N_SPLITS, sizeof(SplitAnswer3D),
                                  .fault = split_middle_fault};

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

const Function overlap_06 = {
    "overlaps",           N_OVERLAPS,
    sizeof(i32),          KNOWING(is_right_overlap, describe_overlap, known_of_overlap),
    .is_known_by_all = 1, .knows_constant = 1};
#undef GIVEN
#undef IS_FOUND

// ---- fits_todo ----------------------------------------------------------------------------------

static Diagnosis fits_fault(const void *job, int i, const void *answers)
{
    const int level = i + 1, expected = level <= TODO_SIZE;
    const i32 found = ((const i32 *)answers)[i];
    (void)job;
    return (found != 0) == expected
               ? NOTHING_WRONG
               : diagnosis_of(
                     message_new("level %d: found %d, expected %d", level, found, expected),
                     (Cause){.says = words("splitting there leaves up to %d nodes waiting, and "
                                           "TODO_SIZE is %d",
                                           level, TODO_SIZE)
                                         .text});
}

const Function fits_06 = {"todo", TODO_LEVELS, sizeof(i32), .fault = fits_fault};
