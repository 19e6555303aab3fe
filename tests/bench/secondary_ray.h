// A ray that begins on a surface, as host and device share it: the bench makes such rays once, and
// its kernel and Embree read the same ones.
//
// The course's own Ray (ray.h) holds float3, which the host does not have.
// Read next: secondary_rays.cl.
#ifndef BENCH_SECONDARY_RAY_H
#define BENCH_SECONDARY_RAY_H

#include "vec3.h"

typedef struct SecondaryRay {
    /*  0 */ Vec3 origin;     // off the surface already
    /* 12 */ f32 t_min;       // 0: hits count beyond it
    /* 16 */ Vec3 direction;  // unit vector
    /* 28 */ f32 t_max;       // where the ray ends: at the light, or INFINITY; 0: there is no ray
} SecondaryRay;
LAYOUT_ASSERT(SecondaryRay, 32);

#endif
