// The camera: where the eye is, how it is turned, and how wide it sees. Set up on the host (lab
// 04), read by every kernel that makes rays.
//
// Space is right-handed. The display is at distance 1 in front of the eye; seen from the eye,
// `right` points along its rows, `up` along its columns, `forward` through its middle. The three
// are unit vectors at right angles, and right x up = -forward: one looks along the negative third
// axis.
// Lecture: slide "Viewing". Flow: scene -> BUFFERS -> KERNEL -> image. Read next: ray.h.
#ifndef KERNELS_CAMERA_H
#define KERNELS_CAMERA_H

#include "vec3.h"

typedef struct Camera {
    /*  0 */ Vec3 eye;      // scene units
    /* 12 */ Vec3 right;    // unit vector
    /* 24 */ Vec3 up;       // unit vector
    /* 36 */ Vec3 forward;  // unit vector
    /* 48 */ f32 fov;       // field of view: the display's width over its distance from the eye
} Camera;
LAYOUT_ASSERT(Camera, 52);

#endif
