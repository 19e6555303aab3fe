// Vectors in double precision, for the 3D oracle and for judges.
#ifndef JUDGE_ORACLE_VECTOR_H
#define JUDGE_ORACLE_VECTOR_H

#include "vec3.h"

#include <math.h>

typedef struct OracleVector {
    double x, y, z;
} OracleVector;

static inline OracleVector vector_of(Vec3 v)
{
    return (OracleVector){v.x, v.y, v.z};
}

// Axis 0 is x, 1 is y, 2 is z.
static inline Vec3 vector_rounded(OracleVector v)
{
    return (Vec3){(float)v.x, (float)v.y, (float)v.z};
}

static inline double vector_component(OracleVector v, u32 axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static inline OracleVector vector_plus(OracleVector a, OracleVector b)
{
    return (OracleVector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline OracleVector vector_minus(OracleVector a, OracleVector b)
{
    return (OracleVector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline OracleVector vector_scaled(double factor, OracleVector v)
{
    return (OracleVector){factor * v.x, factor * v.y, factor * v.z};
}

static inline double vector_dot(OracleVector a, OracleVector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline OracleVector vector_cross(OracleVector a, OracleVector b)
{
    return (OracleVector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double vector_length(OracleVector v)
{
    return sqrt(vector_dot(v, v));
}

// As long as 1; a vector of length 0 stays so.
static inline OracleVector vector_unit(OracleVector v)
{
    const double length = vector_length(v);
    return length > 0 ? vector_scaled(1 / length, v) : v;
}

#endif
