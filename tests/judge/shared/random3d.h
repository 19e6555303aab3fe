// Random numbers and points for the inputs of the 3D labs.
#ifndef JUDGE_RANDOM3D_H
#define JUDGE_RANDOM3D_H

#include "random.h"
#include "vec3.h"

#include <math.h>

// 1 in one case of n, else 0.
static inline int one_in(Random *random, int n)
{
    return random_integer(random, 1, n) == 1;
}

// A number from lowest to highest in steps of 1/1024.
static inline float random_number(Random *random, double lowest, double highest)
{
    return (float)random_integer(random, llrint(lowest * 1024), llrint(highest * 1024)) / 1024;
}

// A number on a grid of 1/8, from lowest to highest.
static inline float random_eighth(Random *random, int lowest, int highest)
{
    return (float)random_integer(random, 8 * (int64_t)lowest, 8 * (int64_t)highest) / 8;
}

// A vector whose parts are numbers in steps of 1/1024.
static inline Vec3 random_vector(Random *random, double lowest, double highest)
{
    const float x = random_number(random, lowest, highest);
    const float y = random_number(random, lowest, highest);
    const float z = random_number(random, lowest, highest);
    return (Vec3){x, y, z};
}

// A point whose coordinates are at most `reach` from 0.
static inline Vec3 random_point(Random *random, double reach)
{
    return random_vector(random, -reach, reach);
}

// A unit vector.
static inline Vec3 random_direction(Random *random)
{
    Vec3 v;
    do {
        v = random_point(random, 1);
    } while (vec3_dot(v, v) < 0.25f);
    return vec3_normalized(v);
}

static inline int random_sign(Random *random)
{
    return random_integer(random, 0, 1) ? 1 : -1;
}

#endif
