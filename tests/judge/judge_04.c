// Judge of lab 04: the camera's axes, pixels on the display, rays, and directions as colours. Read
// next: judge_04.h.
#include "judge_04.h"

static const Check checks[] = {
    [AXES_ORTHONORMAL] = {"axes-orthonormal", "Unit vectors at right angles, right to view.up, too",
                          "camera_axes", 10},
    [AXES_FORWARD] = {"axes-forward", "Forward goes to the point looked at", "camera_axes", 10},
    [AXES_UP] = {"axes-up", "Right is to the right and up is up", "camera_axes", 10},
    [DISPLAY_SIDES] = {"display-sides", "x grows to the right, y upwards, z is 1",
                       "pixel_on_display", 8},
    [DISPLAY_MIDDLE] = {"display-middle", "The middle of the pixel, in square pictures",
                        "pixel_on_display", 11},
    [DISPLAY_ASPECT] = {"display-aspect", "Wide and high pictures have square pixels",
                        "pixel_on_display", 11},
    [RAY_TRANSFORM] = {"ray-transform", "From the camera's axes to the scene's", "primary_ray", 14,
                       "pixel_on_display"},
    [RAY_UNIT] = {"ray-unit", "The direction is a unit vector", "primary_ray", 8},
    [RAY_LIMITS] = {"ray-limits", "From the eye on, without an end", "primary_ray", 8},
    [COLOR_PICTURE] = {"color-picture", "From -1 to 1 becomes from 0 to 1", "direction_color", 6,
                       "primary_ray pixel_on_display"},
    [COLOR_CHANNELS] = {"color-channels", "x is red, y is green, z is blue", "direction_color", 4,
                        "primary_ray pixel_on_display"},
};

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job04 *job = pointer;
    switch (check) {
    case AXES_ORTHONORMAL:
    case AXES_FORWARD:
    case AXES_UP:
        return judge_04_axes(job, check, answers);
    case DISPLAY_SIDES:
    case DISPLAY_MIDDLE:
    case DISPLAY_ASPECT:
        return judge_04_display(job, check, answers);
    case COLOR_PICTURE:
        return job_pictures_judge(job->pictures, RANDOM, 2, answers);
    case COLOR_CHANNELS:
        return job_pictures_judge(job->pictures, ALONG, 3, answers);
    default:
        return judge_04_rays(job, check, answers);
    }
}

// The oracle's pictures stay the reference: see judge_05.c.
static void adopt(void *job, const Sections *answers)
{
    (void)job, (void)answers;
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job04 *job = pointer;
    job_pictures_report(job->pictures, N_PICTURES, answers, result);
}

const Judge judge_04 = {
    .lab = "04-camera-rays",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_04_new,
    .job_free = job_04_free,
    .judge = judge,
    .write_alone = judge_04_write_alone,
    .passes_alone = judge_04_passes_alone,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
