// Lab 04: pixel_on_display on the job's pixels. See judge_04.h; judge_04_rays.c is the sibling.
//
// What is expected comes from oracle3d.h, in double precision; DISPLAY_ERROR_04 is how far float
// may be off.
#include "judge_04.h"

#include "message.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>

static const OracleRules3D right = {0};

// ---- Known mistakes -----------------------------------------------------------------------------

// A mistake that would explain wrong points.
typedef struct DisplayMistake {
    Cause cause;
    OracleRules3D rules;
    int mirrored, flipped, transposed;
    int columns, rows;                          // how many pixels on
    OracleVector (*point)(const PixelJob *in);  // in the place of all these
} DisplayMistake;

// A point on a display on which the middle is at (x, y) and a pixel of this size.
static OracleVector point_from(const PixelJob *in, double x, double y, double size)
{
    return (OracleVector){(in->x + 0.5 - x) * size, (y - in->y - 0.5) * size, 1};
}

static double pixel_size(const PixelJob *in)
{
    return (double)in->camera.fov / in->width;
}

static OracleVector point_of_longer_side(const PixelJob *in)
{
    const int longer = in->width > in->height ? in->width : in->height;
    return point_from(in, in->width / 2.0, in->height / 2.0, (double)in->camera.fov / longer);
}

static OracleVector point_of_whole_halves(const PixelJob *in)
{
    const int x = in->width / 2, y = in->height / 2;
    return point_from(in, x, y, pixel_size(in));
}

static OracleVector point_of_whole_half_height(const PixelJob *in)
{
    const int y = in->height / 2;
    return point_from(in, in->width / 2.0, y, pixel_size(in));
}

static OracleVector point_of_halves_rounded_up(const PixelJob *in)
{
    const int x = (in->width + 1) / 2, y = (in->height + 1) / 2;
    return point_from(in, x, y, pixel_size(in));
}

static OracleVector point_of_whole_steps(const PixelJob *in)
{
    const int x = (2 * in->x + 1 - in->width) / 2, y = (in->height - 2 * in->y - 1) / 2;
    return (OracleVector){x * pixel_size(in), y * pixel_size(in), 1};
}

static OracleVector point_from_border_to_border(const PixelJob *in)
{
    const double fov = in->camera.fov, height = fov * in->height / in->width;
    return (OracleVector){((double)in->x / (in->width - 1) - 0.5) * fov,
                          (0.5 - (double)in->y / (in->height - 1)) * height, 1};
}

// With y times this in the place of height / width.
static OracleVector point_of_aspect(const PixelJob *in, double aspect)
{
    const double fov = in->camera.fov;
    return (OracleVector){((in->x + 0.5) / in->width - 0.5) * fov,
                          (0.5 - (in->y + 0.5) / in->height) * fov * aspect, 1};
}

static OracleVector point_of_inverse_aspect(const PixelJob *in)
{
    return point_of_aspect(in, (double)in->width / in->height);
}

static OracleVector point_of_whole_aspect(const PixelJob *in)
{
    const int aspect = in->height / in->width;
    return point_of_aspect(in, aspect);
}

static OracleVector point_made_unit(const PixelJob *in)
{
    return vector_unit(point_from(in, in->width / 2.0, in->height / 2.0, pixel_size(in)));
}

static OracleVector point_of_width_1(const PixelJob *in)
{
    OracleVector p = point_from(in, in->width / 2.0, in->height / 2.0, 1.0 / in->width);
    p.z = 1 / (double)in->camera.fov;
    return p;
}

static const DisplayMistake display_mistakes[] = {
    {.cause = {0}},  // none
    {.cause = {"shifted by half a pixel: that is the pixel's corner, not its middle",
               MISTAKE_SHIFTED_HALF},
     .rules = {.sample_offset = -0.5}},
    {.cause = {"shifted by half a pixel: that is the pixel's far corner, not its middle",
               MISTAKE_SHIFTED_HALF},
     .rules = {.sample_offset = 0.5}},
    {.cause = {.says = "fov is the display's width, not half of it"},
     .rules = {.fov_is_half_width = 1}},
    {.cause = {.says = "fov is the display's width, not its height"},
     .rules = {.fov_is_height = 1}},
    {.cause = {.says = "pixels are squares: y needs the same size of a pixel as x"},
     .rules = {.fov_both_ways = 1}},
    {.cause = {"mirrored: x grows to the right", MISTAKE_MIRRORED_X}, .mirrored = 1},
    {.cause = {"flipped: row 0 is the top row, where y is largest", MISTAKE_FLIPPED_Y},
     .flipped = 1},
    {.cause = {.says = "fov is a width at distance 1, not an angle"}, .rules = {.fov_is_angle = 1}},
    {.cause = {"transposed: x counts columns and y rows", MISTAKE_TRANSPOSED}, .transposed = 1},
    {.cause = {"shifted by one pixel to the right: columns count from 0", MISTAKE_SHIFTED_ONE},
     .columns = 1},
    // Nobody counts from -1: the half that leads to the middle was taken off.
    {.cause = {"shifted by one pixel to the left: half a pixel has the wrong sign",
               MISTAKE_SHIFTED_ONE},
     .columns = -1},
    {.cause = {"shifted by one pixel down: rows count from 0", MISTAKE_SHIFTED_ONE}, .rows = 1},
    {.cause = {"shifted by one pixel up: half a pixel has the wrong sign", MISTAKE_SHIFTED_ONE},
     .rows = -1},
    {.cause = {"shifted by one pixel to the left and up: half a pixel has the wrong sign",
               MISTAKE_SHIFTED_ONE},
     .columns = -1,
     .rows = -1},
    {.cause = {"shifted by one pixel to the right and down: columns and rows count from 0",
               MISTAKE_SHIFTED_ONE},
     .columns = 1,
     .rows = 1},
    {.cause = {.says = "fov is the display's width, and not the longer side's"},
     .point = point_of_longer_side},
    {.cause = {.says = "half of an odd width or height has lost its half: the division is one of "
                       "whole numbers"},
     .point = point_of_whole_halves},
    {.cause = {.says = "half of an odd height has lost its half: the division is one of whole "
                       "numbers"},
     .point = point_of_whole_half_height},
    {.cause = {.says = "half of an odd width or height was rounded up: the middle of the display "
                       "lies in the middle of a pixel there"},
     .point = point_of_halves_rounded_up},
    {.cause = {.says = "steps from the middle are whole numbers there, but odd halves in pictures "
                       "of even size"},
     .point = point_of_whole_steps},
    {.cause = {.says = "the first and the last pixel stand on the borders: a picture has as many "
                       "steps as pixels, and a pixel's middle is half a step from the border"},
     .point = point_from_border_to_border},
    {.cause = {.says = "y is scaled by width / height: it is height / width"},
     .point = point_of_inverse_aspect},
    {.cause = {.says = "height / width is a division of whole numbers there"},
     .point = point_of_whole_aspect},
    {.cause = {.says = "the point was made a unit vector: it stands on the display, at z = 1"},
     .point = point_made_unit},
    {.cause = {.says =
                   "that display is 1 wide: it must stand at distance 1, and be as wide as fov"},
     .point = point_of_width_1},
};

// ---- Judging ------------------------------------------------------------------------------------

static int display_agrees(const void *pointer, int i, const void *answers, int number)
{
    const PixelJob *job = &((const Job04 *)pointer)->pixels[i];
    const Vec3 found = ((const PixelAnswer *)answers)[i].on_display;
    const DisplayMistake *mistake = &display_mistakes[number];
    const double half = job->camera.fov / 2 * fmax(1, (double)job->height / job->width);
    const double error = DISPLAY_ERROR_04 * fmax(half, 1);
    if (mistake->point != NULL) {
        const OracleVector p = mistake->point(job);
        return is_near_04(found, p, error * fmax(1, vector_length(p)));
    }
    const int x = (mistake->transposed ? job->y : job->x) + mistake->columns;
    const int y = (mistake->transposed ? job->x : job->y) + mistake->rows;
    OracleVector p =
        oracle3d_display(x, y, job->width, job->height, job->camera.fov, &mistake->rules);
    p.x = mistake->mirrored ? -p.x : p.x;
    p.y = mistake->flipped ? -p.y : p.y;
    return is_near_04(found, p, error);
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

const Function display_sides_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                                   COMPARED(side_agrees, describe_point, display_mistakes),
                                   .counted = "points"};
const Function display_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                             COMPARED(display_agrees, describe_point, display_mistakes),
                             .counted = "points"};
