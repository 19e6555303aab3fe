// One sphere of a 3D scene: read from a file or generated on the host (common/scene3d.h), read by
// every kernel that traces rays.
//
// A sphere with a negative radius is seen from inside only: its near side is not there, as the file
// format NFF has it. How large it is, is fabs(radius).
// Flow: SCENE -> BUFFERS -> KERNEL -> image. Read next: intersect_sphere.cl of lab 05.
#ifndef KERNELS_SPHERE_H
#define KERNELS_SPHERE_H

#include "layout.h"

typedef struct Sphere {
    /*  0 */ f32 x;  // centre, scene units
    /*  4 */ f32 y;
    /*  8 */ f32 z;
    /* 12 */ f32 radius;  // scene units; negative: seen from inside only
} Sphere;
LAYOUT_ASSERT(Sphere, 16);

#endif
