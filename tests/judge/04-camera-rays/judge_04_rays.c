// Lab 04: pixel_on_display and primary_ray on the job's pixels. See judge_04.h; judge_04_axes.c is
// the sibling.
//
// What is expected comes from oracle3d.h, in double precision, and so do the bounds on rounding.
#include "judge_04.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const OracleRules3D right = {0};

// Of a point on the display, as a share of the display's half width: see oracle3d.c.
#define DISPLAY_ERROR (32 * 0x1p-24)

int is_near_04(Vec3 found, OracleVector expected, double error)
{
    return fabs(found.x - expected.x) <= error && fabs(found.y - expected.y) <= error &&
           fabs(found.z - expected.z) <= error;
}

int is_opposite_04(Vec3 found, OracleVector expected, double error)
{
    return is_near_04(found, (OracleVector){-expected.x, -expected.y, -expected.z}, error);
}

// ---- Pixels on the display --------------------------------------------------------------------

// A mistake that would explain wrong points.
typedef struct DisplayMistake {
    const char *says;
    OracleRules3D rules;
    int mirrored, flipped, transposed;
    int columns, rows;  // how many pixels on
} DisplayMistake;

static const DisplayMistake display_mistakes[] = {
    {0},  // none
    {.says = "; shifted by half a pixel: that is the pixel's corner, not its middle",
     .rules = {.sample_offset = -0.5}},
    {.says = "; shifted by half a pixel: that is the pixel's far corner, not its middle",
     .rules = {.sample_offset = 0.5}},
    {.says = "; fov is the display's width, not half of it", .rules = {.fov_is_half_width = 1}},
    {.says = "; fov is the display's width, not its height", .rules = {.fov_is_height = 1}},
    {.says = "; pixels are squares: y needs the same size of a pixel as x",
     .rules = {.fov_both_ways = 1}},
    {.says = "; mirrored: x grows to the right", .mirrored = 1},
    {.says = "; flipped: row 0 is the top row, where y is largest", .flipped = 1},
    {.says = "; fov is a width at distance 1, not an angle", .rules = {.fov_is_angle = 1}},
    {.says = "; transposed: x counts columns and y rows", .transposed = 1},
    {.says = "; shifted by one pixel to the right: columns count from 0", .columns = 1},
    // Nobody counts from -1: the half that leads to the middle was taken off.
    {.says = "; shifted by one pixel to the left: half a pixel has the wrong sign", .columns = -1},
    {.says = "; shifted by one pixel down: rows count from 0", .rows = 1},
    {.says = "; shifted by one pixel up: half a pixel has the wrong sign", .rows = -1},
    {.says = "; shifted by one pixel to the left and up: half a pixel has the wrong sign",
     .columns = -1,
     .rows = -1},
    {.says = "; shifted by one pixel to the right and down: columns and rows count from 0",
     .columns = 1,
     .rows = 1},
};

static int display_agrees(const void *pointer, int i, const void *answers, int number)
{
    const PixelJob *job = &((const Job04 *)pointer)->pixels[i];
    const Vec3 found = ((const PixelAnswer *)answers)[i].on_display;
    const DisplayMistake *mistake = &display_mistakes[number];
    const int x = (mistake->transposed ? job->y : job->x) + mistake->columns;
    const int y = (mistake->transposed ? job->x : job->y) + mistake->rows;
    OracleVector p =
        oracle3d_display(x, y, job->width, job->height, job->camera.fov, &mistake->rules);
    p.x = mistake->mirrored ? -p.x : p.x;
    p.y = mistake->flipped ? -p.y : p.y;
    const double half = job->camera.fov / 2 * fmax(1, (double)job->height / job->width);
    return is_near_04(found, p, DISPLAY_ERROR * fmax(half, 1));
}

// The sides only: which half of the display the point is in. The middle itself says nothing.
static int is_on_its_side(const PixelJob *job, Vec3 found)
{
    const int right_of_middle = 2 * job->x + 1 - job->width;
    const int above_middle = job->height - 2 * job->y - 1;
    // A corner may be on the other side of a middle pixel.
    return (abs(right_of_middle) <= 1 || (found.x > 0) == (right_of_middle > 0)) &&
           (abs(above_middle) <= 1 || (found.y > 0) == (above_middle > 0)) && found.z == 1 &&
           isfinite(found.x) && isfinite(found.y);
}

static int side_agrees(const void *job, int i, const void *answers, int mistake)
{
    return mistake == 0 ? is_on_its_side(&((const Job04 *)job)->pixels[i],
                                         ((const PixelAnswer *)answers)[i].on_display)
                        : display_agrees(job, i, answers, mistake);
}

static char *describe_point(const void *pointer, int i, const void *answers)
{
    const PixelJob *in = &((const Job04 *)pointer)->pixels[i];
    const OracleVector e =
        oracle3d_display(in->x, in->y, in->width, in->height, in->camera.fov, &right);
    return message_new("pixel (%d, %d) of %dx%d, fov %g: found %s, expected %s", in->x, in->y,
                       in->width, in->height, in->camera.fov,
                       words_vec3(((const PixelAnswer *)answers)[i].on_display, 6).text,
                       words_xyz(e.x, e.y, e.z, 6).text);
}

const Function display_sides_04 = {"pixels",
                                   N_ALL_PIXELS,
                                   sizeof(PixelAnswer),
                                   .fault = describe_point,
                                   .agrees = side_agrees,
                                   .counted = "points",
                                   MISTAKES(display_mistakes)};
const Function display_04 = {"pixels",
                             N_ALL_PIXELS,
                             sizeof(PixelAnswer),
                             .fault = describe_point,
                             .agrees = display_agrees,
                             .counted = "points",
                             MISTAKES(display_mistakes)};

// ---- Rays -------------------------------------------------------------------------------------

// What is wrong with the direction of pixel number i, or NULL; of any length.
static const char *direction_fault(const PixelJob *job, int i, Vec3 found)
{
    const OracleRules3D transposed = {.axes_transposed = 1};
    const OracleRay ray =
        oracle3d_primary_ray(&job->camera, job->x, job->y, job->width, job->height, &right);
    const OracleRay other =
        oracle3d_primary_ray(&job->camera, job->x, job->y, job->width, job->height, &transposed);
    const double length = vec3_length(found), error = ray.direction_error;
    const Vec3 unit = {(float)(found.x / length), (float)(found.y / length),
                       (float)(found.z / length)};
    // A sum with the eye rounds to the eye's digits.
    const double eye_error = 4 * 0x1p-24 * vec3_length(job->camera.eye);
    if (length > 0 && is_near_04(unit, ray.direction, error)) {
        return NULL;
    }
    return length == 0 ? ": it is zero"
           : is_near_04(unit, other.direction, error)
               ? "; the view transform is turned round: x times right plus y times up plus z times "
                 "forward"
           : is_opposite_04(unit, ray.direction, error) ? "; it points backwards"
           : i >= FIRST_FAR_EYE && is_near_04(unit, ray.direction, eye_error)
               ? "; from a near eye it is right, from a far eye its digits are lost: the eye, a "
                 "large number, has no part in the direction"
               : "";
}

// The same for where a ray begins and ends.
static const char *limits_fault(const PixelJob *job, const PixelAnswer *found)
{
    const Vec3 eye = job->camera.eye;
    return found->origin.x != eye.x || found->origin.y != eye.y || found->origin.z != eye.z
               ? "; the ray begins at the eye"
           : found->t_min != 0          ? "; what is before the eye counts from 0 on"
           : !(found->t_max >= FLT_MAX) ? "; the ray has no end: t_max is INFINITY"
                                        : NULL;
}

static char *describe_direction(const PixelJob *in, const PixelAnswer *own, const char *fault)
{
    const Vec3 d = own->direction;
    const OracleVector e =
        oracle3d_primary_ray(&in->camera, in->x, in->y, in->width, in->height, &right).direction;
    return fault == NULL
               ? NULL
               : message_new("pixel (%d, %d) of %dx%d: found direction %s of length %.6g, expected "
                             "%s%s",
                             in->x, in->y, in->width, in->height, words_vec3(d, 6).text,
                             vec3_length(d), words_xyz(e.x, e.y, e.z, 6).text, fault);
}

static char *transform_fault(const void *job, int i, const void *answers)
{
    const PixelJob *in = &((const Job04 *)job)->pixels[i];
    const PixelAnswer *own = (const PixelAnswer *)answers + i;
    return describe_direction(in, own, direction_fault(in, i, own->direction));
}

static char *unit_fault(const void *job, int i, const void *answers)
{
    const PixelAnswer *own = (const PixelAnswer *)answers + i;
    const double length = vec3_length(own->direction);
    return describe_direction(&((const Job04 *)job)->pixels[i], own,
                              fabs(length - 1) <= DISPLAY_ERROR
                                  ? NULL
                                  : "; it must be a unit vector, so that t is a distance: "
                                    "normalize()");
}

static char *ray_limits_fault(const void *job, int i, const void *answers)
{
    const PixelJob *in = &((const Job04 *)job)->pixels[i];
    const PixelAnswer *own = (const PixelAnswer *)answers + i;
    const char *fault = limits_fault(in, own);
    return fault == NULL
               ? NULL
               : message_new("pixel (%d, %d) of %dx%d: found origin %s, t_min %g, t_max %g, "
                             "expected %s, 0 and inf%s",
                             in->x, in->y, in->width, in->height, words_vec3(own->origin, 6).text,
                             own->t_min, own->t_max, words_vec3(in->camera.eye, 6).text, fault);
}

const Function ray_transform_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                                   .fault = transform_fault};
const Function ray_unit_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer), .fault = unit_fault};
const Function ray_limits_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                                .fault = ray_limits_fault};
