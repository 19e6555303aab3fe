// What a sphere looks like, and the lights that show it.
//
// Flow: SCENE -> BUFFERS -> KERNEL -> image. Read next: shade.cl of lab 05.
#ifndef KERNELS_SHADING_H
#define KERNELS_SHADING_H

#include "vec3.h"

// As the file format NFF has it, line "f": colour, then what the surface does with light. Lab 05
// uses colour and kd, lab 09 ks as well; the rest is read and not used.
typedef struct Material {
    /*  0 */ Vec3 color;  // red, green, blue, 0 to 1
    /* 12 */ f32 kd;      // share of light scattered in all directions (Lambert)
    /* 16 */ f32 ks;      // share of light reflected
    /* 20 */ f32 shine;   // Phong's exponent of highlights
    /* 24 */ f32 transmittance;
    /* 28 */ f32 refraction;  // index of refraction
} Material;
LAYOUT_ASSERT(Material, 32);

// A light at a point. Its brightness is the same at any distance.
typedef struct Light {
    /*  0 */ Vec3 position;  // scene units
    /* 12 */ Vec3 color;     // red, green, blue; 1 is full brightness, and more is brighter
} Light;
LAYOUT_ASSERT(Light, 24);

#endif
