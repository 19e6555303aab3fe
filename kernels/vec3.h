// Three numbers: a point, a direction or a colour, as host and device share them, and the vector
// arithmetic that the host needs. The device has float3 for that; to_float3() converts to it.
//
// Why not float3 in shared structures? It takes 16 bytes, and the host has no such type.
// Flow: scene -> BUFFERS -> KERNEL -> image. Read next: camera.h, sphere.h.
#ifndef KERNELS_VEC3_H
#define KERNELS_VEC3_H

#include "layout.h"

typedef struct Vec3 {
    /* 0 */ f32 x;
    /* 4 */ f32 y;
    /* 8 */ f32 z;
} Vec3;
LAYOUT_ASSERT(Vec3, 12);

#ifdef __OPENCL_C_VERSION__

static inline float3 to_float3(Vec3 v)
{
    return (float3)(v.x, v.y, v.z);
}

// The component of v along an axis: 0 is x, 1 is y, 2 is z. OpenCL C has no v[axis].
static inline float component(float3 v, uint axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

#else

#include <math.h>

static inline Vec3 vec3_minus(Vec3 a, Vec3 b)
{
    return (Vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline Vec3 vec3_scaled(Vec3 v, f32 factor)
{
    return (Vec3){factor * v.x, factor * v.y, factor * v.z};
}

static inline f32 vec3_dot(Vec3 a, Vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// The vector at right angles to both; a, b and it are right-handed, like x, y and z.
static inline Vec3 vec3_cross(Vec3 a, Vec3 b)
{
    return (Vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// In double the squares of a float's largest and smallest numbers are still numbers.
static inline double vec3_length(Vec3 v)
{
    return sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
}

// The vector of length 1 in the direction of v, which is not zero.
static inline Vec3 vec3_normalized(Vec3 v)
{
    return vec3_scaled(v, (f32)(1 / vec3_length(v)));
}

#endif

#endif
