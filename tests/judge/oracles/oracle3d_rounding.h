// How far float's vectors may be off: for the 3D oracle's own files, and judges that follow it.
#ifndef JUDGE_ORACLE3D_ROUNDING_H
#define JUDGE_ORACLE3D_ROUNDING_H

#include "oracle_vector.h"
#include "sphere.h"

#include <math.h>

#define ROUNDING 0x1p-24           // u, the rounding of one float operation
#define UNIT_ERROR (8 * ROUNDING)  // of a unit vector made by normalize(): see 1 in oracle3d.c

// How far t may be off that a right solution computes for a plane, in units of (|plane| + |origin|)
// / |direction|: one rounding for the difference, five for the division (2.5 ulp, OpenCL 1.2, 7.4)
// or the inverse, one for the product, and the same once more where both terms are multiplied
// before they are subtracted.
#define PLANE_ERROR (16 * ROUNDING)

// Of a device's pow(), a share of the value: 16 ulp (OpenCL 1.2, 7.4).
#define POW_ERROR (32 * ROUNDING)

// How far the direction of a vector of this length may be off when the vector is off by `error`.
static inline double direction_error(double error, double length)
{
    return length > error ? error / (length - error) + UNIT_ERROR : INFINITY;
}

static inline OracleVector centre_of(Sphere sphere)
{
    return (OracleVector){sphere.x, sphere.y, sphere.z};
}

#endif
