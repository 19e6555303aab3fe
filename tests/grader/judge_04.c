// Judge of lab 04: the camera's axes, pixels on the display, rays, and directions as colours.
//
// What is expected comes from oracle3d.h, in double precision, and so do the bounds on rounding.
#include "judge.h"

#include "job_picture.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "oracle3d.h"
#include "random.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

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
    [RAY_TRANSFORM] = {"ray-transform", "From the camera's axes to the scene's", "primary_ray", 14},
    [RAY_UNIT] = {"ray-unit", "The direction is a unit vector", "primary_ray", 8},
    [RAY_LIMITS] = {"ray-limits", "From the eye on, without an end", "primary_ray", 8},
    [COLOR_PICTURE] = {"color-picture", "From -1 to 1 becomes from 0 to 1", "direction_color", 6},
    [COLOR_CHANNELS] = {"color-channels", "x is red, y is green, z is blue", "direction_color", 4},
};

// Pixels in three ranges: anywhere, in square pictures, in wide and high ones.
enum { N_VIEWS = 600, N_PIXELS = 500, N_RANGES = 3, N_ALL_PIXELS = N_RANGES * N_PIXELS };
enum { ANYWHERE, SQUARE, OBLONG };

// Two pictures of any camera, then one along each axis.
enum { RANDOM = 0, ALONG = 2, N_PICTURES = ALONG + 3 };

typedef struct Job {
    ViewJob views[N_VIEWS];
    PixelJob pixels[N_ALL_PIXELS];
    JobPicture directions[N_PICTURES];
    JobPicture *pictures[N_PICTURES];  // the directions
} Job;

static const OracleRules3D right = {0};

// How far a right solution's axes may be off: a difference, two cross products and two
// normalisations in float, each of few roundings of 2^-24; the cross product with `up` loses as
// many digits more as the angle between the two is small, of which draw_view() sets a lowest sine
// of 1/4.
#define AXES_ERROR (64 * 0x1p-24)

// Of a point on the display, as a share of the display's half width: see oracle3d.c.
#define DISPLAY_ERROR (32 * 0x1p-24)

// ---- Drawing the job --------------------------------------------------------------------------

// A number from lowest to highest in steps of 1/1024.
static float number(Random *random, double lowest, double highest)
{
    return (float)random_integer(random, llrint(lowest * 1024), llrint(highest * 1024)) / 1024;
}

static Vec3 vector(Random *random, double reach)
{
    return (Vec3){number(random, -reach, reach), number(random, -reach, reach),
                  number(random, -reach, reach)};
}

// Any view whose direction is a quarter of a unit or longer; its up is of any length, mostly not at
// right angles to it.
static ViewJob draw_view(Random *random)
{
    ViewJob view;
    Vec3 way, aside;
    do {
        view = (ViewJob){vector(random, 5), vector(random, 3), vector(random, 4)};
        way = vec3_minus(view.at, view.from);
        aside = vec3_cross(way, view.up);
    } while (vec3_length(way) < 0.25f || vec3_length(view.up) < 0.25f ||
             vec3_length(aside) < 0.25f * vec3_length(way) * vec3_length(view.up));
    return view;
}

static Vec3 to_vec3(OracleVector v)
{
    return (Vec3){(float)v.x, (float)v.y, (float)v.z};
}

static Camera camera_of(ViewJob job, float fov)
{
    const View view = {.from = job.from, .at = job.at, .up = job.up};
    OracleVector axes[3];
    oracle3d_axes(&view, axes);
    return (Camera){job.from, to_vec3(axes[0]), to_vec3(axes[1]), to_vec3(axes[2]), fov};
}

static PixelJob draw_pixel(Random *random, int range)
{
    PixelJob job = {.camera = camera_of(draw_view(random), number(random, 0.25, 2.5))};
    job.width = (i32)random_integer(random, 2, 300);
    job.height = (i32)random_integer(random, 2, 300);
    if (range == SQUARE) {
        job.height = job.width;
    } else if (range == OBLONG && random_integer(random, 0, 1)) {
        job.height = job.width * 2 + 1;
    } else if (range == OBLONG) {
        job.width = job.height * 3;
    }
    job.x = (i32)random_integer(random, 0, job.width - 1);
    job.y = (i32)random_integer(random, 0, job.height - 1);
    return job;
}

// The picture of the directions, in double precision.
static int expect_directions(const Camera *camera, int width, int height, JobPicture *picture)
{
    ExpectedPicture *expected = &picture->expected;
    if (image_create(width, height, &expected->reference) != 0) {
        return -1;
    }
    expected->background[3] = 1;
    float *pixel = expected->reference.pixels;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++, pixel += IMAGE_CHANNELS) {
            const OracleRay ray = oracle3d_primary_ray(camera, x, y, width, height, &right);
            pixel[0] = (float)((ray.direction.x + 1) / 2);
            pixel[1] = (float)((ray.direction.y + 1) / 2);
            pixel[2] = (float)((ray.direction.z + 1) / 2);
            pixel[3] = 1;
            // Half of the direction's, and the rounding of product and sum.
            expected->tolerance = (float)(ray.direction_error / 2 + 2 * 0x1p-24);
        }
    }
    return 0;
}

static int draw_pictures(Random *random, Job *job, FILE *file)
{
    static const int sizes[N_PICTURES][2] = {{96, 64}, {49, 67}, {48, 48}, {48, 48}, {48, 48}};
    static const Vec3 ways[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    static const Vec3 ups[3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    static const char *const names[3] = {"x", "y", "-z"};
    int result = 0;
    for (int k = 0; result == 0 && k < N_PICTURES; k++) {
        JobPicture *picture = &job->directions[k];
        const int width = sizes[k][0], height = sizes[k][1];
        SceneJob3D scene = {.width = width, .height = height};
        if (k < ALONG) {
            scene.camera = camera_of(draw_view(random), number(random, 0.5, 1.5));
            snprintf(picture->title, sizeof picture->title, "directions, %dx%d", width, height);
        } else {
            scene.camera = camera_of((ViewJob){{0}, ways[k - ALONG], ups[k - ALONG]}, 1);
            snprintf(picture->title, sizeof picture->title, "directions, looking along %s",
                     names[k - ALONG]);
        }
        job->pictures[k] = picture;
        result = expect_directions(&scene.camera, width, height, picture);
        result |= job_section_write(file, k, NULL, &scene, sizeof scene);
    }
    return result;
}

static void job_free(void *pointer)
{
    Job *job = pointer;
    for (int k = 0; k < N_PICTURES; k++) {
        expected_picture_free(&job->directions[k].expected);
    }
    free(job);
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    for (int i = 0; i < N_VIEWS; i++) {
        job->views[i] = draw_view(&random);
    }
    for (int i = 0; i < N_ALL_PIXELS; i++) {
        job->pixels[i] = draw_pixel(&random, i / N_PIXELS);
    }
    int result = section_write(file, "views", job->views, sizeof job->views);
    result |= section_write(file, "pixels", job->pixels, sizeof job->pixels);
    if (result != 0 || draw_pictures(&random, job, file) != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

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
                   ? "not all three are unit vectors"
               : !is_across(found->forward, found->right) || !is_across(found->up, found->right)
                   ? "right is not at right angles to the others"
               : !is_across(found->forward, found->up) ? "up is not at right angles to forward"
               : !is_across(found->right, view->up)    ? "right is not at right angles to view.up"
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
        return is_opposite(found->forward, wanted) ? "forward points backwards"
                                                   : "forward does not go from `from` to `at`";
    }
    const int is_right = is_near(found->right, expected[0], AXES_ERROR);
    const int is_up = is_near(found->up, expected[1], AXES_ERROR);
    if (is_right && is_up) {
        return NULL;
    }
    return is_opposite(found->right, expected[0])
               ? "right points to the left: mind the order of the cross product"
           : is_opposite(found->up, expected[1])
               ? "up points down: mind the order of the cross product"
           : is_right ? "up is not what is left of view.up at right angles to forward"
                      : "right is not forward x up";
}

static Verdict judge_axes(const Job *job, int check, const Sections *answers)
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
            "%.4g), up (%.4g, %.4g, %.4g), forward (%.4g, %.4g, %.4g); %s",
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
    {.says = "; shifted by one pixel to the left: columns count from 0", .columns = -1},
    {.says = "; shifted by one pixel down: rows count from 0", .rows = 1},
    {.says = "; shifted by one pixel up: rows count from 0", .rows = -1},
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

static Verdict judge_display(const Job *job, int check, const Sections *answers)
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
        "pixel (%d, %d) of %dx%d, fov %g: found (%.6g, %.6g, %.6g), expected (%.6g, %.6g, %.6g)%s; "
        "%d of %d points are wrong",
        in->x, in->y, in->width, in->height, (double)in->camera.fov, (double)own.x, (double)own.y,
        (double)own.z, expected.x, expected.y, expected.z, why, n_wrong, N_PIXELS));
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
    return length == 0 ? "; it is zero"
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

static Verdict judge_rays(const Job *job, int check, const Sections *answers)
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

// ---- All of it --------------------------------------------------------------------------------

static Verdict judge(const void *pointer, int check, const Sections *answers)
{
    const Job *job = pointer;
    switch (check) {
    case AXES_ORTHONORMAL:
    case AXES_FORWARD:
    case AXES_UP:
        return judge_axes(job, check, answers);
    case DISPLAY_SIDES:
    case DISPLAY_MIDDLE:
    case DISPLAY_ASPECT:
        return judge_display(job, check, answers);
    case COLOR_PICTURE:
        return job_pictures_judge(job->pictures, RANDOM, 2, answers);
    case COLOR_CHANNELS:
        return job_pictures_judge(job->pictures, ALONG, 3, answers);
    default:
        return judge_rays(job, check, answers);
    }
}

// The oracle's pictures stay the reference: see judge_05.c.
static void adopt(void *job, const Sections *answers)
{
    (void)job, (void)answers;
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job *job = pointer;
    job_pictures_report(job->pictures, N_PICTURES, answers, result);
}

const Judge judge_04 = {
    "04-camera-rays", checks, sizeof checks / sizeof *checks, job_new, job_free, judge, adopt,
    add_pictures,
};
