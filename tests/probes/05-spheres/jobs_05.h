// The sections of lab 05's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_05_H
#define PROBES_JOBS_05_H

#include "jobs.h"

// Section "roots", one call of nearest_root each. Answered by an f32.
typedef struct RootJob {
    f32 b;
    f32 disc;
    f32 radius;
    f32 t_min;
} RootJob;
LAYOUT_ASSERT(RootJob, 16);

// Sections "textbook" and "projection", one call of intersect_textbook or intersect_sphere
// each. Answered by an f32.
typedef struct SphereRayJob {
    Sphere sphere;
    Vec3 origin;
    Vec3 direction;
    f32 t_min;
    i32 unused;
} SphereRayJob;
LAYOUT_ASSERT(SphereRayJob, 48);

// Lab 05, alone: in the scenes of nearest_hit the ray of pixel (x, y) goes from (x, y, 0) along z,
// with this t_min. Answered by "hits.K" and "work.K", both width x height.
#define SQUARES_T_MIN 0.25f

// Section "normals", one call of surface_normal each. Answered by a Vec3.
typedef struct NormalJob {
    Sphere sphere;
    Vec3 point;
    Vec3 direction;
} NormalJob;
LAYOUT_ASSERT(NormalJob, 40);

// Section "shades", one call of shade each, and alone "pixel_shades", those of whole
// pictures. Answered by a Vec3. The lights are n_lights from first_light on in section "lights";
// what follows them must not shine.
typedef struct ShadeJob {
    Vec3 point;
    Vec3 normal;
    Material material;
    i32 first_light;
    i32 n_lights;
} ShadeJob;
LAYOUT_ASSERT(ShadeJob, 64);

#endif
