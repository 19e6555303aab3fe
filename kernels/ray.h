// A ray, the part of it that counts, and what it hits. The device's own: the host never sees them.
//
//     point at distance t:  origin + t * direction
//
// A hit counts when t > t_min. For a ray from the eye t_min is 0, and t_max is INFINITY: it has no
// end; a shadow ray of lab 09 ends at its light. Lab 07 starts with the two and narrows them to the
// part of the ray inside a node, in variables of its own.
// Lecture: slide "Viewing". Flow: scene -> buffers -> KERNEL -> image. Read next: sphere.h.
#ifndef KERNELS_RAY_H
#define KERNELS_RAY_H

#include "vec3.h"

#ifdef __OPENCL_C_VERSION__

typedef struct Ray {
    float3 origin;     // scene units
    float3 direction;  // unit vector, so that t is a distance in scene units
    float t_min;       // hits count beyond it; not negative
    float t_max;       // where the ray ends
} Ray;

// Hit.sphere where nothing is hit.
#define NO_SPHERE 0xffffffffu

typedef struct Hit {
    float t;      // distance from the ray's origin; INFINITY when nothing is hit
    uint sphere;  // its index in spheres[]; NO_SPHERE when nothing is hit
} Hit;

#endif

#endif
