// Lab 04: each function on the job's inputs. See judge_04.h.
//
// What is expected comes from oracle3d.h, in double precision, and so do the bounds on rounding.
#include "judge_04.h"

#include "message.h"
#include "oracle3d.h"

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

// What is wrong with an answer in one check, or NULL.
static const char *axes_fault(int check, const ViewJob *view, const Axes *found,
                              const OracleVector expected[3])
{
    if (check == AXES_ORTHONORMAL) {
        return !is_unit(found->forward) || !is_unit(found->right) || !is_unit(found->up)
                   ? ": not all three are unit vectors"
               : !is_across(found->forward, found->right) || !is_across(found->up, found->right)
                   ? ": right is not at right angles to the others"
               : !is_across(found->forward, found->up) ? ": up is not at right angles to forward"
               : !is_across(found->right, view->up)    ? ": right is not at right angles to view.up"
                                                       : NULL;
    }
    // Of any length: that is the business of the check above.
    const double forward_length = sqrt(dot(found->forward, in_double(found->forward)));
    if (check == AXES_FORWARD) {
        const OracleVector wanted = expected[2];
        if (is_near(found->forward,
                    (OracleVector){forward_length * wanted.x, forward_length * wanted.y,
                                   forward_length * wanted.z},
                    AXES_ERROR * forward_length) &&
            forward_length > 0) {
            return NULL;
        }
        return is_opposite(found->forward, wanted) ? "; forward points backwards"
                                                   : ": forward does not go from `from` to `at`";
    }
    const int is_right = is_near(found->right, expected[0], AXES_ERROR);
    const int is_up = is_near(found->up, expected[1], AXES_ERROR);
    if (is_right && is_up) {
        return NULL;
    }
    return is_opposite(found->right, expected[0])
               ? "; right points to the left: mind the order of the cross product"
           : is_opposite(found->up, expected[1])
               ? "; up points down: mind the order of the cross product"
           : is_right ? ": up is not what is left of view.up at right angles to forward"
                      : ": right is not forward x up";
}

Verdict judge_04_axes(const Job04 *job, int check, const Sections *answers)
{
    const Axes *found = sections_find(answers, "axes", N_VIEWS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_VIEWS; i++) {
        const ViewJob *job_view = &job->views[i];
        const View view = {.from = job_view->from, .at = job_view->at, .up = job_view->up};
        OracleVector expected[3];
        oracle3d_axes(&view, expected);
        const Axes own = found[i];
        const char *fault = axes_fault(check, job_view, &own, expected);
        if (fault == NULL) {
            continue;
        }
        return verdict_of(message_new(
            "view from (%g, %g, %g) at (%g, %g, %g) up (%g, %g, %g): found right (%.4g, %.4g, "
            "%.4g), up (%.4g, %.4g, %.4g), forward (%.4g, %.4g, %.4g), expected right (%.4g, %.4g, "
            "%.4g), up (%.4g, %.4g, %.4g), forward (%.4g, %.4g, %.4g)%s",
            (double)view.from.x, (double)view.from.y, (double)view.from.z, (double)view.at.x,
            (double)view.at.y, (double)view.at.z, (double)view.up.x, (double)view.up.y,
            (double)view.up.z, (double)own.right.x, (double)own.right.y, (double)own.right.z,
            (double)own.up.x, (double)own.up.y, (double)own.up.z, (double)own.forward.x,
            (double)own.forward.y, (double)own.forward.z, expected[0].x, expected[0].y,
            expected[0].z, expected[1].x, expected[1].y, expected[1].z, expected[2].x,
            expected[2].y, expected[2].z, fault));
    }
    return verdict_of(NULL);
}

// ---- Pixels on the display --------------------------------------------------------------------

// A mistake that would explain wrong points; all zeros is none.
typedef struct DisplayMistake {
    const char *says;
    OracleRules3D rules;
    int mirrored, flipped, transposed;
    int columns, rows;  // how many pixels on
} DisplayMistake;

static const DisplayMistake no_mistake = {0};
static const DisplayMistake display_mistakes[] = {
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

static int display_agrees(const PixelJob *job, Vec3 found, const DisplayMistake *mistake)
{
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

Verdict judge_04_display(const Job04 *job, int check, const Sections *answers)
{
    const PixelAnswer *found = sections_find(answers, "pixels", N_ALL_PIXELS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    const size_t n_mistakes = sizeof display_mistakes / sizeof *display_mistakes;
    const int range = check == DISPLAY_SIDES ? ANYWHERE : check == DISPLAY_MIDDLE ? SQUARE : OBLONG;
    int n_wrong = 0, first = 0;
    unsigned explained = ~0u;  // a bit for each mistake that explains all points so far
    for (int i = (range + 1) * N_PIXELS - 1; i >= range * N_PIXELS; i--) {
        const Vec3 own = found[i].on_display;
        if (check == DISPLAY_SIDES ? !is_on_its_side(&job->pixels[i], own)
                                   : !display_agrees(&job->pixels[i], own, &no_mistake)) {
            n_wrong++;
            first = i;
        }
        for (size_t mistake = 0; mistake < n_mistakes; mistake++) {
            if (!display_agrees(&job->pixels[i], own, &display_mistakes[mistake])) {
                explained &= ~(1u << mistake);
            }
        }
    }
    if (n_wrong == 0) {
        return verdict_of(NULL);
    }
    const char *why = "";
    for (size_t mistake = n_mistakes; mistake-- > 0;) {
        why = explained >> mistake & 1 ? display_mistakes[mistake].says : why;
    }
    const PixelJob *in = &job->pixels[first];
    const Vec3 own = found[first].on_display;
    const OracleVector expected =
        oracle3d_display(in->x, in->y, in->width, in->height, in->camera.fov, &right);
    return verdict_of(message_new(
        "pixel (%d, %d) of %dx%d, fov %g: found (%.6g, %.6g, %.6g), expected (%.6g, %.6g, %.6g) "
        "(%d of %d points are wrong)%s",
        in->x, in->y, in->width, in->height, (double)in->camera.fov, (double)own.x, (double)own.y,
        (double)own.z, expected.x, expected.y, expected.z, n_wrong, N_PIXELS, why));
}

// ---- Rays -------------------------------------------------------------------------------------

// What is wrong with a ray's direction, or NULL; of any length.
static const char *direction_fault(const PixelJob *job, Vec3 found)
{
    const OracleRules3D transposed = {.axes_transposed = 1};
    const OracleRay ray =
        oracle3d_primary_ray(&job->camera, job->x, job->y, job->width, job->height, &right);
    const OracleRay other =
        oracle3d_primary_ray(&job->camera, job->x, job->y, job->width, job->height, &transposed);
    const double length = sqrt(dot(found, in_double(found)));
    const Vec3 unit = {(float)(found.x / length), (float)(found.y / length),
                       (float)(found.z / length)};
    if (length > 0 && is_near(unit, ray.direction, ray.direction_error)) {
        return NULL;
    }
    return length == 0 ? ": it is zero"
           : is_near(unit, other.direction, ray.direction_error)
               ? "; the view transform is turned round: x times right plus y times up plus z times "
                 "forward"
           : is_opposite(unit, ray.direction) ? "; it points backwards"
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

Verdict judge_04_rays(const Job04 *job, int check, const Sections *answers)
{
    const PixelAnswer *found = sections_find(answers, "pixels", N_ALL_PIXELS * sizeof *found);
    if (found == NULL) {
        return verdict_missing;
    }
    for (int i = 0; i < N_ALL_PIXELS; i++) {
        const PixelJob *in = &job->pixels[i];
        const PixelAnswer *own = &found[i];
        const Vec3 d = own->direction;
        const double length = sqrt(dot(d, in_double(d)));
        const OracleVector expected =
            oracle3d_primary_ray(&in->camera, in->x, in->y, in->width, in->height, &right)
                .direction;
        const char *fault =
            check == RAY_TRANSFORM ? direction_fault(in, d)
            : check == RAY_LIMITS  ? limits_fault(in, own)
            : fabs(length - 1) <= DISPLAY_ERROR
                ? NULL
                : "; it must be a unit vector, so that t is a distance: normalize()";
        if (fault == NULL) {
            continue;
        }
        if (check == RAY_LIMITS) {
            return verdict_of(message_new(
                "pixel (%d, %d) of %dx%d: found origin (%g, %g, %g), t_min %g, t_max %g, expected "
                "(%g, %g, %g), 0 and inf%s",
                in->x, in->y, in->width, in->height, (double)own->origin.x, (double)own->origin.y,
                (double)own->origin.z, (double)own->t_min, (double)own->t_max,
                (double)in->camera.eye.x, (double)in->camera.eye.y, (double)in->camera.eye.z,
                fault));
        }
        return verdict_of(message_new(
            "pixel (%d, %d) of %dx%d: found direction (%.6g, %.6g, %.6g) of length %.6g, expected "
            "(%.6g, %.6g, %.6g)%s",
            in->x, in->y, in->width, in->height, (double)d.x, (double)d.y, (double)d.z, length,
            expected.x, expected.y, expected.z, fault));
    }
    return verdict_of(NULL);
}
