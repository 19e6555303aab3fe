// Known mistakes of "does a circle, or a sphere, overlap a cell?" (labs 02 and 06), for a file
// whose GIVEN (known.h) also declares `reach`. Every input is such that double decides it exactly.
#ifndef JUDGE_OVERLAP_KNOWN_H
#define JUDGE_OVERLAP_KNOWN_H

#include "known.h"
#include "overlap_reach.h"

// Does the square around the circle, or the cube around the sphere, overlap the cell? What misses
// by little may be decided by how its sides were rounded.
static int is_of_box(Reach reach, int found)
{
    const double radius = fabs(reach.radius), furthest = reach_furthest(reach);
    return fabs(furthest - radius) <= 0.01 * radius || found == (furthest < radius);
}

// By how much it misses the cell, as an epsilon may be meant: of squares, of distances, or as a
// share of the radius.
static int is_by_epsilon(Reach reach)
{
    return reach_squared(reach) - reach.radius * reach.radius <= 1 || reach_apart(reach) <= 0.5 ||
           reach_apart(reach) <= fabs(reach.radius) / 16;
}

KNOWN_LIST(overlap_known)
{
    GIVEN;
    const double radius = reach.radius, radius2 = radius * radius, distance2 = reach_squared(reach);
    const float float2 = reach_squared_in_float(reach);

    ANSWERS(by_sum, reach.outside[0] + reach.outside[1] + reach.outside[2] <= fabs(radius),
            "the distances on the axes are added: their squares are to be");
    ANY(radius_not_squared, 2, IS_FOUND(distance2 <= (way ? radius : fabs(radius))),
        "your answers are those of distance² <= radius, without its square");
    ANSWERS(by_root, sqrt(distance2) <= fabs(radius),
            "your answers are those of a root, which is rounded: compare the squares");
    ANSWERS(distances_in_float, reach_squared(reach_in_float(reach)) <= radius2,
            "your answers are those of distances rounded to float: in double they are exact");
#define IN_FLOAT "your answers are those of float, which rounds squares: in double they are exact"
    ANSWERS(squares_in_float, float2 <= (float)radius * (float)radius, IN_FLOAT);
    ANSWERS(root_in_float, sqrtf(float2) <= fabsf((float)radius), IN_FLOAT);
    ANSWERS(radius_in_float, distance2 <= (double)((float)radius * (float)radius),
            "your answers are those of a radius squared in float, which rounds it");

    // In 2D z is 0: to leave it out is right.
#define ONE_AXIS_LESS "your answers are those of a distance without one of its axes"
    ANSWERS(without_x, reach_without(reach, 0) <= radius2, ONE_AXIS_LESS);
    ANSWERS(without_y, reach_without(reach, 1) <= radius2, ONE_AXIS_LESS);
    ANSWERS(without_z, reach_without(reach, 2) <= radius2, ONE_AXIS_LESS);

    // A point on a cell's border touches it, too.
    ONLY(radius_0, !found && radius == 0,
         "a radius of 0 makes a point, and it overlaps the cells that it is in");
    ONLY(negative_radius, !found && radius < 0, "a negative radius counts as its absolute value");
    ONLY(touching, !found && distance2 == radius2,
         "they touch, and touching counts: both have their boundaries", MISTAKE_STRICT_BOUNDARY);
    ONLY(epsilon, found && is_by_epsilon(reach),
         "your answers are those with an epsilon: in double none is needed");
    return NO_MORE;
}

#endif
