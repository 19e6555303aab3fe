// Judge of lab 04: the camera's axes, pixels on the display, rays, and directions as colours. Read
// next: judge_04.h.
#include "judge_04.h"

static const JudgeCheck checks[] = {
    {"axes-orthonormal", "Unit vectors at right angles, right to view.up, too", "camera_axes",
     .function = &axes_orthonormal_04, .range = {0, N_VIEWS}},
    {"axes-forward", "Forward goes to the point looked at", "camera_axes",
     .function = &axes_forward_04, .range = {0, N_VIEWS}},
    {"axes-up", "Right is to the right and up is up", "camera_axes", .function = &axes_up_04,
     .range = {0, N_VIEWS}},

    {"display-sides", "x grows to the right, y upwards, z is 1", "pixel_on_display",
     .function = &display_sides_04, .range = {ANYWHERE, N_PIXELS}},
    {"display-middle", "The middle of the pixel, in square pictures", "pixel_on_display",
     .function = &display_04, .range = {SQUARE, N_PIXELS}},
    {"display-aspect", "Wide and high pictures have square pixels", "pixel_on_display",
     .function = &display_04, .range = {ANYWHERE, N_ALL_PIXELS - ANYWHERE}},

    {"ray-transform", "From the camera's axes to the scene's", "primary_ray", "pixel_on_display",
     .function = &ray_transform_04, .range = {0, N_ALL_PIXELS}, .alone = are_turned_04,
     .alone_cause = judge_function_alone},
    {"ray-unit", "The direction is a unit vector", "primary_ray", .function = &ray_unit_04,
     .range = {0, N_ALL_PIXELS}},
    {"ray-limits", "From the eye on, without an end", "primary_ray", .function = &ray_limits_04,
     .range = {0, N_ALL_PIXELS}},

    {"color-picture", "From -1 to 1 becomes from 0 to 1", "direction_color",
     "primary_ray pixel_on_display", .scene = judge_picture, .range = {RANDOM, ALONG - RANDOM},
     .alone_scene = is_drawn_04, .alone_cause = drawn_cause_04},
    {"color-channels", "x is red, y is green, z is blue", "direction_color",
     "primary_ray pixel_on_display", .scene = judge_picture, .range = {ALONG, N_PICTURES - ALONG},
     .alone_scene = is_drawn_04, .alone_cause = drawn_cause_04},
};

static void describe_view(const void *input, char *words, size_t n_bytes)
{
    const ViewJob *in = input;
    snprintf(words, n_bytes, "from (%g, %g, %g) at (%g, %g, %g) up (%g, %g, %g)",
             (double)in->from.x, (double)in->from.y, (double)in->from.z, (double)in->at.x,
             (double)in->at.y, (double)in->at.z, (double)in->up.x, (double)in->up.y,
             (double)in->up.z);
}

static const JobPart parts[] = {
    INPUTS("views", "camera_axes", Job04, views, .describe = describe_view),
    INPUTS("pixels", "pixel_on_display primary_ray", Job04, pixels),
};

const Judge judge_04 = {
    .lab = "04-camera-rays",
    .checks = checks,
    .n_checks = COUNT(checks),
    .job_bytes = sizeof(Job04),
    .roll = roll_job_04,
    .parts = parts,
    .n_parts = COUNT(parts),
    .scenes = SCENES(picture_kind, Job04, directions),
    .scene_steps = {{"picture", "in draw_directions", NULL}},
    .write_scene = job_04_write_scene,
    .write_alone = write_alone_04,
};
