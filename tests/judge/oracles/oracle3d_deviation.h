// How errors grow from mirror to mirror: each source of rounding on a ray's way, followed to first
// order, as a ray that starts a little beside and goes a little beside. For oracle3d_mirrors.c.
#ifndef JUDGE_ORACLE3D_DEVIATION_H
#define JUDGE_ORACLE3D_DEVIATION_H

#include "oracle3d_rounding.h"

// What one source does: its own size is in it.
typedef struct Deviation {
    OracleVector origin, direction;
} Deviation;

// Three for the ray from the eye, and seven for each mirror; beside stubs, which move the point
// by an error in all directions and not along the normal alone, nine. So many mirrors that a limit
// of 128 shows.
enum { MOST_DEVIATED_MIRRORS = 136, MAX_DEVIATIONS = 3 + 9 * MOST_DEVIATED_MIRRORS };
typedef struct Deviations {
    Deviation each[MAX_DEVIATIONS];
    int n;
} Deviations;

// How far the ray may be off together.
double deviations_of_origin(const Deviations *deviations);
double deviations_of_direction(const Deviations *deviations);

// An error of a direction, whichever way it goes.
void deviations_add_direction(Deviations *deviations, double error);

// An error of a point, whichever way it goes, and one along a vector.
void deviations_add_origin(Deviations *deviations, double error);
void deviations_add_along(Deviations *deviations, OracleVector error);

// Move all of them on to a hit at distance t of a surface with this unit normal: `origin` is then
// how far the point is off.
void deviations_hit(Deviations *deviations, OracleVector direction, OracleVector normal, double t);

// And on to the mirrored direction.
//   curvature   of the mirror towards the normal: 1 / radius where it bulges, else negative
void deviations_mirror(Deviations *deviations, OracleVector direction, OracleVector normal,
                       double curvature);

// The same where every ray leaves along the normal.
void deviations_leave_along_normal(Deviations *deviations, double curvature);

// And where that direction is one of another length, which is made a unit vector.
void deviations_make_unit(Deviations *deviations, OracleVector direction);

#endif
