// Lab 04: each function on the job's inputs. See judge_04.h.
//
// What is expected comes from oracle3d.h, in double precision, and so do the bounds on rounding.
#include "judge_04.h"

#include "message.h"
#include "oracle3d.h"
#include "words.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const OracleRules3D right = {0};

// How far a right solution's axes may be off: a difference, two cross products and two
// normalisations in float, each of few roundings of 2^-24; the cross product with `up` loses as
// many digits more as the angle between the two is small, of which draw_view() sets a lowest sine
// of 1/4.
#define AXES_ERROR (64 * 0x1p-24)

// Of a point on the display, as a share of the display's half width: see oracle3d.c.
#define DISPLAY_ERROR (32 * 0x1p-24)

// ---- The camera's axes ------------------------------------------------------------------------

typedef struct Axes {
    Vec3 right, up, forward;
} Axes;

static double dot(Vec3 a, OracleVector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static OracleVector in_double(Vec3 v)
{
    return (OracleVector){v.x, v.y, v.z};
}

static int is_unit(Vec3 v)
{
    return fabs(sqrt(dot(v, in_double(v))) - 1) <= AXES_ERROR;
}

static int is_across(Vec3 a, Vec3 b)
{
    const double length = sqrt(dot(b, in_double(b)));
    return fabs(dot(a, in_double(b))) <= AXES_ERROR * fmax(length, 1);
}

static int is_near(Vec3 found, OracleVector expected, double error)
{
    return fabs(found.x - expected.x) <= error && fabs(found.y - expected.y) <= error &&
           fabs(found.z - expected.z) <= error;
}

static int is_opposite(Vec3 found, OracleVector expected)
{
    return is_near(found, (OracleVector){-expected.x, -expected.y, -expected.z}, AXES_ERROR);
}

// What is said of wrong axes: a remark on what was found, or what it looks like. Neither where
// nothing is wrong.
typedef struct AxesFault {
    const char *remark;  // ": right is not forward x up"
    const char *looks;   // "forward points backwards"
} AxesFault;
typedef AxesFault JudgeAxes(const ViewJob *view, const Axes *found, const OracleVector expected[3]);

static AxesFault not_orthonormal(const ViewJob *view, const Axes *found,
                                 const OracleVector expected[3])
{
    (void)expected;
    const char *remark =
        !is_unit(found->forward) || !is_unit(found->right) || !is_unit(found->up)
            ? ": not all three are unit vectors"
        : !is_across(found->forward, found->right) || !is_across(found->up, found->right)
            ? ": right is not at right angles to the others"
        : !is_across(found->forward, found->up) ? ": up is not at right angles to forward"
        : !is_across(found->right, view->up)    ? ": right is not at right angles to view.up"
                                                : NULL;
    return (AxesFault){.remark = remark};
}

// Of any length: that is the business of the check above.
static AxesFault not_forward(const ViewJob *view, const Axes *found, const OracleVector expected[3])
{
    const double length = sqrt(dot(found->forward, in_double(found->forward)));
    const OracleVector f = expected[2], wanted = {length * f.x, length * f.y, length * f.z};
    (void)view;
    if (is_near(found->forward, wanted, AXES_ERROR * length) && length > 0) {
        return (AxesFault){0};
    }
    if (is_opposite(found->forward, f)) {
        return (AxesFault){.looks = "forward points backwards"};
    }
    return (AxesFault){.remark = ": forward does not go from `from` to `at`"};
}

static AxesFault not_upright(const ViewJob *view, const Axes *found, const OracleVector expected[3])
{
    const int is_right = is_near(found->right, expected[0], AXES_ERROR);
    const int is_up = is_near(found->up, expected[1], AXES_ERROR);
    (void)view;
    if (is_right && is_up) {
        return (AxesFault){0};
    }
    if (is_opposite(found->right, expected[0])) {
        return (AxesFault){.looks =
                               "right points to the left: mind the order of the cross product"};
    }
    if (is_opposite(found->up, expected[1])) {
        return (AxesFault){.looks = "up points down: mind the order of the cross product"};
    }
    return (AxesFault){
        .remark = is_right ? ": up is not what is left of view.up at right angles to forward"
                           : ": right is not forward x up"};
}

static Diagnosis axes_fault(const void *pointer, int i, const void *answers, JudgeAxes *judge)
{
    const ViewJob *job = &((const Job04 *)pointer)->views[i];
    const View view = {.from = job->from, .at = job->at, .up = job->up};
    const Axes own = ((const Axes *)answers)[i];
    OracleVector e[3];
    oracle3d_axes(&view, e);
    const AxesFault fault = judge(job, &own, e);
    if (fault.remark == NULL && fault.looks == NULL) {
        return NOTHING_WRONG;
    }
    char *found = message_new(
        "view from %s at %s up %s: found right %s, up %s, forward %s, expected right %s, up %s, "
        "forward %s%s",
        words_vec3(view.from, 6).text, words_vec3(view.at, 6).text, words_vec3(view.up, 6).text,
        words_vec3(own.right, 4).text, words_vec3(own.up, 4).text, words_vec3(own.forward, 4).text,
        words_xyz(e[0].x, e[0].y, e[0].z, 4).text, words_xyz(e[1].x, e[1].y, e[1].z, 4).text,
        words_xyz(e[2].x, e[2].y, e[2].z, 4).text, fault.remark != NULL ? fault.remark : "");
    return diagnosis_of(found, (Cause){.says = fault.looks});
}

static Diagnosis orthonormal_fault(const void *job, int i, const void *answers)
{
    return axes_fault(job, i, answers, not_orthonormal);
}

static Diagnosis forward_fault(const void *job, int i, const void *answers)
{
    return axes_fault(job, i, answers, not_forward);
}

static Diagnosis upright_fault(const void *job, int i, const void *answers)
{
    return axes_fault(job, i, answers, not_upright);
}

const Function axes_orthonormal_04 = {"axes", N_VIEWS, sizeof(Axes), .fault = orthonormal_fault};
const Function axes_forward_04 = {"axes", N_VIEWS, sizeof(Axes), .fault = forward_fault};
const Function axes_up_04 = {"axes", N_VIEWS, sizeof(Axes), .fault = upright_fault};

// ---- Pixels on the display --------------------------------------------------------------------

// A mistake that would explain wrong points.
typedef struct DisplayMistake {
    Cause cause;
    OracleRules3D rules;
    int mirrored, flipped, transposed;
    int columns, rows;  // how many pixels on
} DisplayMistake;

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
    return is_near(found, p, DISPLAY_ERROR * fmax(half, 1));
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
                                   .describe = describe_point,
                                   .agrees = side_agrees,
                                   .counted = "points",
                                   MISTAKES(display_mistakes)};
const Function display_04 = {"pixels",
                             N_ALL_PIXELS,
                             sizeof(PixelAnswer),
                             .describe = describe_point,
                             .agrees = display_agrees,
                             .counted = "points",
                             MISTAKES(display_mistakes)};

// ---- Rays -------------------------------------------------------------------------------------

static OracleRay ray_of(const PixelJob *job, const OracleRules3D *rules)
{
    return oracle3d_primary_ray(&job->camera, job->x, job->y, job->width, job->height, rules);
}

// A wrong direction.
//   remark   joins what was found
static Diagnosis describe_direction(const PixelJob *in, Vec3 found, const char *remark, Cause cause)
{
    const OracleVector e = ray_of(in, &right).direction;
    return diagnosis_of(
        message_new("pixel (%d, %d) of %dx%d: found direction %s of length %.6g, expected %s%s",
                    in->x, in->y, in->width, in->height, words_vec3(found, 6).text,
                    sqrt(dot(found, in_double(found))), words_xyz(e.x, e.y, e.z, 6).text, remark),
        cause);
}

// Is a ray's direction right, of any length?
static Diagnosis transform_fault(const void *job, int i, const void *answers)
{
    const OracleRules3D transposed = {.axes_transposed = 1};
    const PixelJob *in = &((const Job04 *)job)->pixels[i];
    const Vec3 found = ((const PixelAnswer *)answers)[i].direction;
    const OracleRay ray = ray_of(in, &right), other = ray_of(in, &transposed);
    const double length = sqrt(dot(found, in_double(found)));
    const Vec3 unit = {(float)(found.x / length), (float)(found.y / length),
                       (float)(found.z / length)};
    if (length == 0) {
        return describe_direction(in, found, ": it is zero", (Cause){0});
    }
    if (is_near(unit, ray.direction, ray.direction_error)) {
        return NOTHING_WRONG;
    }
    const char *looks = is_near(unit, other.direction, ray.direction_error)
                            ? "the view transform is turned round: x times right plus y times up "
                              "plus z times forward"
                        : is_opposite(unit, ray.direction) ? "it points backwards"
                                                           : NULL;
    return describe_direction(in, found, "", (Cause){.says = looks});
}

static Diagnosis unit_fault(const void *job, int i, const void *answers)
{
    static const Cause not_unit = {
        .says = "it must be a unit vector, so that t is a distance: normalize()"};
    const Vec3 found = ((const PixelAnswer *)answers)[i].direction;
    const double length = sqrt(dot(found, in_double(found)));
    return fabs(length - 1) <= DISPLAY_ERROR
               ? NOTHING_WRONG
               : describe_direction(&((const Job04 *)job)->pixels[i], found, "", not_unit);
}

// Where a ray begins and ends.
static Diagnosis ray_limits_fault(const void *job, int i, const void *answers)
{
    const PixelJob *in = &((const Job04 *)job)->pixels[i];
    const PixelAnswer *own = (const PixelAnswer *)answers + i;
    const Vec3 eye = in->camera.eye;
    const char *looks = own->origin.x != eye.x || own->origin.y != eye.y || own->origin.z != eye.z
                            ? "the ray begins at the eye"
                        : own->t_min != 0          ? "what is before the eye counts from 0 on"
                        : !(own->t_max >= FLT_MAX) ? "the ray has no end: t_max is INFINITY"
                                                   : NULL;
    if (looks == NULL) {
        return NOTHING_WRONG;
    }
    char *found = message_new(
        "pixel (%d, %d) of %dx%d: found origin %s, t_min %g, t_max %g, expected %s, 0 and inf",
        in->x, in->y, in->width, in->height, words_vec3(own->origin, 6).text, own->t_min,
        own->t_max, words_vec3(eye, 6).text);
    return diagnosis_of(found, (Cause){.says = looks});
}

const Function ray_transform_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                                   .fault = transform_fault};
const Function ray_unit_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer), .fault = unit_fault};
const Function ray_limits_04 = {"pixels", N_ALL_PIXELS, sizeof(PixelAnswer),
                                .fault = ray_limits_fault};
