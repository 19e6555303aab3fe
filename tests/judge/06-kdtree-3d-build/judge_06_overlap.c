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

// The distances of a line that was copied and not changed all through: on one axis the coordinate,
// or the borders, are another's.
static int copied(SphereBoxJob in, int axis, int of_coordinate, int of_borders)
{
    const double centre[3] = {in.sphere.x, in.sphere.y, in.sphere.z};
    double distance2 = 0;
    for (int k = 0; k < 3; k++) {
        const int c = k == axis ? of_coordinate : k, b = k == axis ? of_borders : k;
        const double outside = outside_of(centre[c], in.box.min[b], in.box.max[b]);
        distance2 += outside * outside;
    }
    return distance2 <= (double)in.sphere.radius * in.sphere.radius;
}

#define OTHER_BORDERS                                                                              \
    "on one axis the borders of another were taken: is a copied line changed all through?"
#define OTHER_COORDINATE                                                                           \
    "on one axis the centre's coordinate on another was taken: is a copied line changed all "      \
    "through?"
#define ONE_TWICE                                                                                  \
    "one axis counts twice, and another not at all: is a copied line changed all through?"
ANSWERS(x_by_y, copied(in, 0, 0, 1), OTHER_BORDERS)
ANSWERS(x_by_z, copied(in, 0, 0, 2), OTHER_BORDERS)
ANSWERS(y_by_x, copied(in, 1, 1, 0), OTHER_BORDERS)
ANSWERS(y_by_z, copied(in, 1, 1, 2), OTHER_BORDERS)
ANSWERS(z_by_x, copied(in, 2, 2, 0), OTHER_BORDERS)
ANSWERS(z_by_y, copied(in, 2, 2, 1), OTHER_BORDERS)
ANSWERS(y_for_x, copied(in, 0, 1, 0), OTHER_COORDINATE)
ANSWERS(z_for_x, copied(in, 0, 2, 0), OTHER_COORDINATE)
ANSWERS(x_for_y, copied(in, 1, 0, 1), OTHER_COORDINATE)
ANSWERS(z_for_y, copied(in, 1, 2, 1), OTHER_COORDINATE)
ANSWERS(x_for_z, copied(in, 2, 0, 2), OTHER_COORDINATE)
ANSWERS(y_for_z, copied(in, 2, 1, 2), OTHER_COORDINATE)
ANSWERS(x_twice, copied(in, 1, 0, 0), ONE_TWICE)
ANSWERS(x_twice_no_z, copied(in, 2, 0, 0), ONE_TWICE)
ANSWERS(y_twice, copied(in, 2, 1, 1), ONE_TWICE)
ANSWERS(z_twice, copied(in, 1, 2, 2), ONE_TWICE)

// The lowest or the highest corner in the place of the nearest point.
static int reaches(SphereBoxJob in, const float corner[3])
{
    const double x = (double)in.sphere.x - corner[0], y = (double)in.sphere.y - corner[1],
                 z = (double)in.sphere.z - corner[2];
    return x * x + y * y + z * z <= (double)in.sphere.radius * in.sphere.radius;
}

#define ONE_CORNER                                                                                 \
    "your answers are those of the distance to one corner of the cell: outside() takes the "       \
    "minimum first, then the maximum"
ANSWERS(to_lowest, reaches(in, in.box.min), ONE_CORNER)
ANSWERS(to_highest, reaches(in, in.box.max), ONE_CORNER)

// How far outside() says it is: below the minimum a negative number.
static double signed_outside(SphereBoxJob in, int axis)
{
    const double centre[3] = {in.sphere.x, in.sphere.y, in.sphere.z};
    return centre[axis] - fmin(fmax(centre[axis], in.box.min[axis]), in.box.max[axis]);
}

static int is_signed_cube(SphereBoxJob in, double radius)
{
    return signed_outside(in, 0) <= radius && signed_outside(in, 1) <= radius &&
           signed_outside(in, 2) <= radius;
}

#define OUTSIDE(axis) reach.outside[axis]
#define SIGNED_CUBE                                                                                \
    "each axis was compared by itself, and below the minimum outside() is negative: the squares "  \
    "of all three add up"
ANSWERS(signed_cube, is_signed_cube(in, RADIUS), SIGNED_CUBE)
ANSWERS(signed_cube_of_size, is_signed_cube(in, fabs(RADIUS)), SIGNED_CUBE)
EACH(cube_of_signed, RADIUS < 0 ? !found || reach_furthest(reach) == 0 : IS_OF_BOX,
     "the sphere's bounding cube overlaps, the sphere does not; and a negative radius counts as "
     "its absolute value")
ANSWERS(any_axis, fmin(OUTSIDE(0), fmin(OUTSIDE(1), OUTSIDE(2))) <= fabs(RADIUS),
        "near on one axis is not near: the squares of all three distances add up")
ANSWERS(level_on_any, OUTSIDE(0) * OUTSIDE(1) * OUTSIDE(2) == 0 || D2 <= RADIUS * RADIUS,
        "level with the cell on one axis, the centre may be far on the others: all three count")

ANSWERS(by_signed_root_strict, sqrt(D2) < RADIUS,
        "touching counts, and a negative radius as its absolute value: compare the squares")
ANSWERS(by_root_strict, sqrt(D2) < fabs(RADIUS),
        "touching counts, and a root is rounded: compare the squares", MISTAKE_STRICT_BOUNDARY)
ANSWERS(signed_radius, D2 <= RADIUS * fabs(RADIUS),
        "a negative radius counts as its absolute value")
ANSWERS(doubled, D2 <= 4 * RADIUS * RADIUS, "the radius was doubled: it is no diameter")
ANSWERS(halved, 4 * D2 <= RADIUS * RADIUS, "the radius was halved: it is no diameter")
ANSWERS(squared_again, D2 *D2 <= RADIUS * RADIUS, "the sum of the squares was squared again")
ANSWERS(inverted, D2 > RADIUS * RADIUS, "1 and 0 are swapped: 1 where they overlap")
ANSWERS(always, 1, "every sphere overlaps every cell then: each leaf lists them all")

static const Known *const known_of_overlap[] = {
    &by_signed_root, &by_middle,     &cube,
    OVERLAP_KNOWN,   &cell_within,   &centre_within,
    &no_corner,      &reaches_in,    &x_by_y,
    &x_by_z,         &y_by_x,        &y_by_z,
    &z_by_x,         &z_by_y,        &y_for_x,
    &z_for_x,        &x_for_y,       &z_for_y,
    &x_for_z,        &y_for_z,       &x_twice,
    &x_twice_no_z,   &y_twice,       &z_twice,
    &to_lowest,      &to_highest,    &by_signed_root_strict,
    &by_root_strict, &signed_radius, &doubled,
    &halved,         &squared_again, &inverted,
    &always,         &signed_cube,   &signed_cube_of_size,
    &cube_of_signed, &any_axis,      &level_on_any};

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
