// How far a cell is from the centre of a circle or a sphere (labs 02 and 06).
#ifndef JUDGE_OVERLAP_REACH_H
#define JUDGE_OVERLAP_REACH_H

#include <math.h>

// How far the centre lies outside of the cell on each axis, 0 where it does not, and how far the
// circle or sphere reaches.
typedef struct Reach {
    double outside[3];  // in 2D z is 0
    double radius;      // as it is given: it may be negative in 3D
} Reach;

// How far a coordinate lies outside of [min, max].
static inline double outside_of(double coordinate, double min, double max)
{
    return coordinate < min ? min - coordinate : coordinate > max ? coordinate - max : 0;
}

static inline double reach_squared(Reach r)
{
    return r.outside[0] * r.outside[0] + r.outside[1] * r.outside[1] + r.outside[2] * r.outside[2];
}

// The same with an axis left out.
static inline double reach_without(Reach r, int axis)
{
    return reach_squared(r) - r.outside[axis] * r.outside[axis];
}

static inline float reach_squared_in_float(Reach r)
{
    const float x = (float)r.outside[0], y = (float)r.outside[1], z = (float)r.outside[2];
    return x * x + y * y + z * z;
}

static inline Reach reach_in_float(Reach r)
{
    return (Reach){{(float)r.outside[0], (float)r.outside[1], (float)r.outside[2]}, r.radius};
}

// By how much the circle or sphere misses the cell; negative where it overlaps.
static inline double reach_apart(Reach r)
{
    return sqrt(reach_squared(r)) - fabs(r.radius);
}

static inline double reach_furthest(Reach r)
{
    return fmax(fmax(r.outside[0], r.outside[1]), r.outside[2]);
}

#endif
