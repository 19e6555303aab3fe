// The sections of lab 04's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_04_H
#define PROBES_JOBS_04_H

#include "jobs.h"

// Section "views", one call of camera_axes each. Answered by "axes", three Vec3: right, up
// and forward, UNWRITTEN where nothing was written.
typedef struct ViewJob {
    Vec3 from;
    Vec3 at;
    Vec3 up;
} ViewJob;
LAYOUT_ASSERT(ViewJob, 36);

// Section "pixels", one call of pixel_on_display and of primary_ray each.
typedef struct PixelJob {
    i32 x;
    i32 y;
    i32 width;
    i32 height;
    Camera camera;
} PixelJob;
LAYOUT_ASSERT(PixelJob, 68);

typedef struct PixelAnswer {
    Vec3 on_display;
    Vec3 origin;  // and the rest of the ray
    Vec3 direction;
    f32 t_min;
    f32 t_max;
} PixelAnswer;
LAYOUT_ASSERT(PixelAnswer, 44);

#endif
