// Random numbers and points for the inputs of the 3D labs.
#ifndef GRADER_RANDOM3D_H
#define GRADER_RANDOM3D_H

#include "random.h"
#include "vec3.h"

#include <math.h>

// A number from lowest to highest in steps of 1/1024.
static inline float random_number(Random *random, double lowest, double highest)
{
    return (float)random_integer(random, llrint(lowest * 1024), llrint(highest * 1024)) / 1024;
}

// A point whose coordinates are at most `reach` from 0.
static inline Vec3 random_point(Random *random, double reach)
{
    const float x = random_number(random, -reach, reach);
    const float y = random_number(random, -reach, reach);
    const float z = random_number(random, -reach, reach);
    return (Vec3){x, y, z};
}

#endif
