// What lab 04's judge asks of a submission: views, pixels and pictures of directions. Drawn in
// judge_04_job.c, judged in judge_04.c and judge_04_functions.c, alone in judge_04_alone.c.
#ifndef GRADER_JUDGE_04_H
#define GRADER_JUDGE_04_H

#include "job_picture.h"
#include "jobs.h"
#include "judge.h"

#include <stdint.h>
#include <stdio.h>

// The checks.
enum {
    AXES_ORTHONORMAL,
    AXES_FORWARD,
    AXES_UP,
    DISPLAY_SIDES,
    DISPLAY_MIDDLE,
    DISPLAY_ASPECT,
    RAY_TRANSFORM,
    RAY_UNIT,
    RAY_LIMITS,
    COLOR_PICTURE,
    COLOR_CHANNELS,
};

// Pixels in three ranges: anywhere, in square pictures, in wide and high ones.
enum { N_VIEWS = 600, N_PIXELS = 500, N_RANGES = 3, N_ALL_PIXELS = N_RANGES * N_PIXELS };
enum { ANYWHERE, SQUARE, OBLONG };

// Two pictures of any camera, then one along each axis.
enum { RANDOM = 0, ALONG = 2, N_PICTURES = ALONG + 3 };

typedef struct Job04 {
    ViewJob views[N_VIEWS];
    PixelJob pixels[N_ALL_PIXELS];
    SceneJob3D scenes[N_PICTURES];
    JobPicture directions[N_PICTURES];
    JobPicture *pictures[N_PICTURES];  // the directions
} Job04;

// See job_new and job_free of judge.h.
void *job_04_new(uint64_t seed, FILE *file);
void job_04_free(void *job);

// Judge camera_axes, pixel_on_display or primary_ray by the answers; `check` is which of the
// function's properties is judged.
Verdict judge_04_axes(const Job04 *job, int check, const Sections *answers);
Verdict judge_04_display(const Job04 *job, int check, const Sections *answers);
Verdict judge_04_rays(const Job04 *job, int check, const Sections *answers);

// See write_alone and passes_alone of judge.h.
int judge_04_write_alone(const void *job, const char *task, FILE *file);
int judge_04_passes_alone(const void *job, int check, const Sections *answers);

extern const Judge judge_04;

#endif
