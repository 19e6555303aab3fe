// Lab 06: sphere_overlaps_box on the job's inputs. See judge_06.h; judge_06_functions.c is the
// sibling.
#include "judge_06.h"

#include "message.h"
#include "overlap_reach.h"
#include "words.h"

#include <math.h>

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

// How far outside() says it is: below the minimum a negative number.
static double signed_outside(double coordinate, double min, double max)
{
    return coordinate - fmin(fmax(coordinate, min), max);
}

// Of each axis the coordinate (0 to 2), the minimum (3 to 5) and the maximum (6 to 8).
static double number_of(SphereBoxJob in, int k)
{
    const float centre[] = {in.sphere.x, in.sphere.y, in.sphere.z};
    return k < 3 ? centre[k] : k < 6 ? in.box.min[k - 3] : in.box.max[k - 6];
}

// On one axis outside() gets other numbers: of all, 9 * 9 * 9 for each axis, or of its own.
enum { N_OTHER_NUMBERS = 3 * 9 * 9 * 9 };
static int reaches_with(SphereBoxJob in, int way, int is_own)
{
    const int given = way % 3, k[3] = {way / 3 % 9, way / 27 % 9, way / 243};
    double distance2 = 0;
    int n_own = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int is_given = axis == given;
        const double outside = signed_outside(number_of(in, is_given ? k[0] : axis),
                                              number_of(in, is_given ? k[1] : axis + 3),
                                              number_of(in, is_given ? k[2] : axis + 6));
        distance2 += outside * outside;
        n_own += k[axis] % 3 == given;
    }
    // The distance from a number to itself is none: that is an axis less.
    const int is_one = is_own == (n_own == 3) && k[0] != k[1] && k[0] != k[2];
    return is_one ? distance2 <= (double)in.sphere.radius * in.sphere.radius : -1;
}

// In the sum one square is another term: one axis' distance times another's, itself, or its size;
// or squares are taken off.
static double sum_with(SphereBoxJob in, int way, double (*term)(const double d[3], int, int))
{
    double d[3], sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        d[axis] =
            signed_outside(number_of(in, axis), number_of(in, axis + 3), number_of(in, axis + 6));
    }
    for (int axis = 0; axis < 3; axis++) {
        sum += term(d, axis, way);
    }
    return sum;
}

static double times_other(const double d[3], int axis, int way)
{
    return axis == way % 3 ? d[axis] * d[(axis + 1 + way / 3) % 3] : d[axis] * d[axis];
}

// A bit for each axis that is not squared; and whether its size is taken.
static double not_squared(const double d[3], int axis, int way)
{
    return !(way >> axis & 1) ? d[axis] * d[axis] : way >> 3 ? fabs(d[axis]) : d[axis];
}

static double taken_off(const double d[3], int axis, int way)
{
    return way >> axis & 1 ? -d[axis] * d[axis] : d[axis] * d[axis];
}

// The lowest or the highest corner in the place of the nearest point.
static int reaches(SphereBoxJob in, const float corner[3])
{
    const double x = (double)in.sphere.x - corner[0], y = (double)in.sphere.y - corner[1],
                 z = (double)in.sphere.z - corner[2];
    return x * x + y * y + z * z <= (double)in.sphere.radius * in.sphere.radius;
}

static int is_signed_cube(SphereBoxJob in, double radius)
{
    int n_near = 0;
    for (int axis = 0; axis < 3; axis++) {
        n_near += signed_outside(number_of(in, axis), number_of(in, axis + 3),
                                 number_of(in, axis + 6)) <= radius;
    }
    return n_near == 3;
}

KNOWN_LIST(known_of_overlap)
{
    GIVEN;
    const double *outside = reach.outside;
    const double radius = reach.radius, radius2 = radius * radius, distance2 = reach_squared(reach);

    ANSWERS(
        by_signed_root, sqrt(distance2) <= radius,
        "a negative radius counts as its absolute value; and the root is rounded: compare squares");

    ANSWERS(by_middle, holds_middle(in),
            "your answers are those of the cell's middle, and another point may be nearer");
    EACH(cube, is_of_box(reach, found != 0),
         "the sphere's bounding cube overlaps, the sphere does not");
    ONLY(cell_within, !found && holds_corner(in, 1),
         "a cell that lies within the sphere overlaps it, too: both have their insides");
    ONLY(centre_within, !found && reach_furthest(reach) == 0,
         "a sphere whose centre is in the cell overlaps it");
    ONLY(no_corner, !found && !holds_corner(in, 0),
         "what is missed holds no corner of the cell: a sphere may come in through a side or over "
         "an edge");
    ONLY(reaches_in, !found && reach_furthest(reach) > 0,
         "its centre is outside but the sphere reaches in");

    ANY(other_axis, N_OTHER_NUMBERS, IS_FOUND(reaches_with(in, way, 0)),
        "on one axis numbers of another were taken: is a copied line changed all through?");
    ANY(other_order, N_OTHER_NUMBERS, IS_FOUND(reaches_with(in, way, 1)),
        "on one axis outside() is not given the coordinate, the minimum and the maximum, in this "
        "order");
    ANY(product, 6, IS_FOUND(sum_with(in, way, times_other) <= radius2),
        "the distance on one axis is multiplied by that on another: each is squared");
    ANY(unsquared, 15, IS_FOUND(sum_with(in, way, not_squared) <= radius2),
        "not the squares of all three distances are added");
    ANY(subtracted, 8, IS_FOUND(sum_with(in, way, taken_off) <= radius2),
        "a square was subtracted: the squares of all three distances add up");

#define ONE_CORNER                                                                                 \
    "your answers are those of the distance to one corner of the cell: outside() takes the "       \
    "minimum first, then the maximum"
    ANSWERS(to_lowest, reaches(in, in.box.min), ONE_CORNER);
    ANSWERS(to_highest, reaches(in, in.box.max), ONE_CORNER);
#define SIGNED_CUBE                                                                                \
    "each axis was compared by itself, and below the minimum outside() is negative: the squares "  \
    "of all three add up"
    ANSWERS(signed_cube, is_signed_cube(in, radius), SIGNED_CUBE);
    ANSWERS(signed_cube_of_size, is_signed_cube(in, fabs(radius)), SIGNED_CUBE);
    EACH(cube_of_signed,
         radius < 0 ? !found || reach_furthest(reach) == 0 : is_of_box(reach, found != 0),
         "the sphere's bounding cube overlaps, the sphere does not; and a negative radius counts "
         "as its absolute value");
    ANSWERS(any_axis, fmin(outside[0], fmin(outside[1], outside[2])) <= fabs(radius),
            "near on one axis is not near: the squares of all three distances add up");
    ANSWERS(
        level_on_any, outside[0] * outside[1] * outside[2] == 0 || distance2 <= radius2,
        "level with the cell on one axis, the centre may be far on the others: all three count");

    ANSWERS(by_signed_root_strict, sqrt(distance2) < radius,
            "touching counts, and a negative radius as its absolute value: compare the squares");
    ANSWERS(by_root_strict, sqrt(distance2) < fabs(radius),
            "touching counts, and a root is rounded: compare the squares", MISTAKE_STRICT_BOUNDARY);
    ANSWERS(signed_radius, distance2 <= radius * fabs(radius),
            "a negative radius counts as its absolute value");
    ANSWERS(no_negative, radius >= 0 && distance2 <= radius2,
            "a negative radius counts as its absolute value");
    ANSWERS(no_radius, radius > 0 && distance2 <= radius2,
            "a negative radius counts as its absolute value, and a sphere of radius 0 is a point");
    ANSWERS(doubled, distance2 <= 4 * radius2, "the radius was doubled: it is no diameter");
    ANSWERS(halved, 4 * distance2 <= radius2, "the radius was halved: it is no diameter");
    ANSWERS(squared_again, distance2 * distance2 <= radius2,
            "the sum of the squares was squared again");
    ANY(inverted, 2, IS_FOUND(way ? distance2 >= radius2 : distance2 > radius2),
        "1 and 0 are swapped: 1 where they overlap");
    ANSWERS(always, 1, "every sphere overlaps every cell then: each leaf lists them all");
    return NO_MORE;
}

static char *describe_overlap(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new("sphere at %s, box %s: found %d, expected %d", words_sphere(in.sphere).text,
                       words_box3d(in.box).text, found,
                       tree3d_judge_sphere(in.sphere, in.box) == SPHERE_INSIDE);
}

const Function overlap_06 = {
    "overlaps", N_OVERLAPS, sizeof(i32),
    KNOWING(is_right_overlap, describe_overlap, overlap_known, known_of_overlap),
    .knows_constant = 1};
