// Known mistakes of "does a circle, or a sphere, overlap a cell?" (labs 02 and 06), for a file
// whose GIVEN (known.h) also declares `reach`. Every input is such that double decides it exactly.
#ifndef JUDGE_OVERLAP_KNOWN_H
#define JUDGE_OVERLAP_KNOWN_H

#include "known.h"
#include "overlap_reach.h"

#define RADIUS reach.radius
#define D2 reach_squared(reach)
#define D2_IN_FLOAT reach_squared_in_float(reach)

#define IN_FLOAT "your answers are those of float, which rounds squares: in double they are exact"

ANSWERS(by_sum, reach.outside[0] + reach.outside[1] + reach.outside[2] <= fabs(RADIUS),
        "the distances on the axes are added: their squares are to be")
ANY(radius_not_squared, 2, IS_FOUND(D2 <= (way ? RADIUS : fabs(RADIUS))),
    "your answers are those of distance² <= radius, without its square")
ANSWERS(by_root, sqrt(D2) <= fabs(RADIUS),
        "your answers are those of a root, which is rounded: compare the squares")
ANSWERS(distances_in_float, reach_squared(reach_in_float(reach)) <= RADIUS * RADIUS,
        "your answers are those of distances rounded to float: in double they are exact")
ANSWERS(squares_in_float, D2_IN_FLOAT <= (float)RADIUS * (float)RADIUS, IN_FLOAT)
ANSWERS(root_in_float, sqrtf(D2_IN_FLOAT) <= fabsf((float)RADIUS), IN_FLOAT)
ANSWERS(radius_in_float, D2 <= (double)((float)RADIUS * (float)RADIUS),
        "your answers are those of a radius squared in float, which rounds it")

// In 2D z is 0: to leave it out is right.
#define WITHOUT(axis) (D2 - reach.outside[axis] * reach.outside[axis] <= RADIUS * RADIUS)
#define ONE_AXIS_LESS "your answers are those of a distance without one of its axes"
ANSWERS(without_x, WITHOUT(0), ONE_AXIS_LESS)
ANSWERS(without_y, WITHOUT(1), ONE_AXIS_LESS)
ANSWERS(without_z, WITHOUT(2), ONE_AXIS_LESS)

// A point on a cell's border touches it, too.
ONLY(radius_0, !found && RADIUS == 0,
     "a radius of 0 makes a point, and it overlaps the cells that it is in")
ONLY(negative_radius, !found && RADIUS < 0, "a negative radius counts as its absolute value")
ONLY(touching, !found && D2 == RADIUS * RADIUS,
     "they touch, and touching counts: both have their boundaries", MISTAKE_STRICT_BOUNDARY)

// By how much it misses the cell, as an epsilon may be meant: of squares, of distances, or as a
// share of the radius.
ONLY(epsilon,
     found && (D2 - RADIUS * RADIUS <= 1 || reach_apart(reach) <= 0.5 ||
               reach_apart(reach) <= fabs(RADIUS) / 16),
     "your answers are those with an epsilon: in double none is needed")

#define OVERLAP_KNOWN                                                                              \
    &by_sum, &radius_not_squared, &by_root, &distances_in_float, &squares_in_float,                \
        &root_in_float, &radius_in_float, &without_x, &without_y, &without_z, &radius_0,           \
        &negative_radius, &touching, &epsilon

// Does the square around the circle, or the cube around the sphere, overlap the cell? What misses
// by little may be decided by how its sides were rounded.
#define IS_OF_BOX                                                                                  \
    (fabs(reach_furthest(reach) - fabs(RADIUS)) <= 0.01 * fabs(RADIUS) ||                          \
     IS_FOUND(reach_furthest(reach) < fabs(RADIUS)))

#endif
