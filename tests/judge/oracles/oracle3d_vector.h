// Vectors of the 3D oracle, and how far float's may be off: for the oracle's own files.
#ifndef JUDGE_ORACLE3D_VECTOR_H
#define JUDGE_ORACLE3D_VECTOR_H

#include "oracle3d.h"

#include <math.h>

#define ROUNDING 0x1p-24           // u, the rounding of one float operation
#define UNIT_ERROR (8 * ROUNDING)  // of a unit vector made by normalize(): see 1 in oracle3d.c

typedef OracleVector Vector;

static inline Vector vector(Vec3 v)
{
    return (Vector){v.x, v.y, v.z};
}

static inline Vector plus(Vector a, Vector b)
{
    return (Vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline Vector minus(Vector a, Vector b)
{
    return (Vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline Vector scaled(double factor, Vector v)
{
    return (Vector){factor * v.x, factor * v.y, factor * v.z};
}

static inline double dot(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline Vector cross(Vector a, Vector b)
{
    return (Vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double length(Vector v)
{
    return sqrt(dot(v, v));
}

static inline Vector unit(Vector v)
{
    const double l = length(v);
    return l > 0 ? scaled(1 / l, v) : v;
}

static inline Vector centre(Sphere sphere)
{
    return (Vector){sphere.x, sphere.y, sphere.z};
}

// How far the direction of a vector of this length may be off when the vector is off by `error`.
static inline double direction_error(double error, double length)
{
    return length > error ? error / (length - error) + UNIT_ERROR : INFINITY;
}

#endif
