// Lab 04: primary_ray on the job's pixels. See judge_04.h; judge_04_display.c is the sibling.
//
// What is expected comes from oracle3d.h, in double precision, and so do the bounds on rounding.
#include "judge_04.h"

#include "message.h"
#include "words.h"

#include <float.h>
#include <math.h>

static const OracleRules3D right = {0};

int is_near_04(Vec3 found, OracleVector expected, double error)
{
    return fabs(found.x - expected.x) <= error && fabs(found.y - expected.y) <= error &&
           fabs(found.z - expected.z) <= error;
}

int is_opposite_04(Vec3 found, OracleVector expected, double error)
{
    return is_near_04(found, (OracleVector){-expected.x, -expected.y, -expected.z}, error);
}

// ---- Known mistakes -----------------------------------------------------------------------------

static OracleRay ray_of(const PixelJob *job, const OracleRules3D *rules)
{
    return oracle3d_primary_ray(&job->camera, job->x, job->y, job->width, job->height, rules);
}

// The direction on the display, as long as it is there: of another pixel, picture or fov.
typedef struct Seen {
    int x, y, width, height;
    float fov;
} Seen;

static Seen seen_by(const PixelJob *in)
{
    return (Seen){in->x, in->y, in->width, in->height, in->camera.fov};
}

static OracleVector display_of(Seen seen)
{
    return oracle3d_display(seen.x, seen.y, seen.width, seen.height, seen.fov, &right);
}

// A point as seen from the eye, turned to the scene's axes.
static OracleVector turned_by(const Camera *camera, OracleVector p)
{
    const OracleVector x = vector_scaled(p.x, vector_of(camera->right));
    const OracleVector y = vector_scaled(p.y, vector_of(camera->up));
    return vector_plus(vector_plus(x, y), vector_scaled(p.z, vector_of(camera->forward)));
}

static OracleVector unturned(const PixelJob *in)
{
    return display_of(seen_by(in));
}

static OracleVector turned_round(const PixelJob *in)
{
    const OracleRules3D transposed = {.axes_transposed = 1};
    return ray_of(in, &transposed).direction;
}

static OracleVector backwards(const PixelJob *in)
{
    return vector_scaled(-1, ray_of(in, &right).direction);
}

static OracleVector with_the_eye(const PixelJob *in)
{
    return vector_plus(vector_of(in->camera.eye), turned_by(&in->camera, unturned(in)));
}

static OracleVector with_fov_1(const PixelJob *in)
{
    Seen seen = seen_by(in);
    seen.fov = 1;
    return turned_by(&in->camera, display_of(seen));
}

static OracleVector with_swapped_size(const PixelJob *in)
{
    Seen seen = seen_by(in);
    seen.width = in->height, seen.height = in->width;
    return turned_by(&in->camera, display_of(seen));
}

static OracleVector with_up_down(const PixelJob *in)
{
    OracleVector p = unturned(in);
    p.y = -p.y;
    return turned_by(&in->camera, p);
}

static OracleVector with_unit_sides(const PixelJob *in)
{
    OracleVector p = unturned(in);
    p.z = 0;
    p = vector_unit(p);
    p.z = 1;
    return turned_by(&in->camera, p);
}

// Mistakes that explain every wrong direction, but for its length. The far eyes are left out: with
// them sums lose digits.
static const struct {
    OracleVector (*direction)(const PixelJob *in);
    const char *says;
} ray_mistakes[] = {
    {turned_round,
     "the view transform is turned round: x times right plus y times up plus z times forward"},
    {backwards, "it points backwards"},
    {unturned, "it is still in the camera's axes: they are to turn it to the scene's"},
    {with_the_eye, "the eye was added: that makes a point, and a direction has no place"},
    {with_fov_1, "that is the direction of a fov of 1, not the camera's"},
    {with_swapped_size, "width and height are swapped"},
    {with_up_down, "up and down are swapped"},
    {with_unit_sides, "the part along the display was made a unit vector before forward was added"},
};

static OracleVector unit_of(Vec3 v)
{
    return vector_unit(vector_of(v));
}

static int is_direction(OracleVector found, OracleVector expected, double error)
{
    return vector_length(vector_minus(found, vector_unit(expected))) <= 2 * error;
}

// What wrong directions look like, or NULL.
static const char *directions_look(const Job04 *job, const PixelAnswer *answers)
{
    for (int m = 0; m < COUNT(ray_mistakes); m++) {
        int i = 0;
        while (i < FIRST_FAR_EYE && is_direction(unit_of(answers[i].direction),
                                                 ray_mistakes[m].direction(&job->pixels[i]),
                                                 ray_of(&job->pixels[i], &right).direction_error)) {
            i++;
        }
        if (i == FIRST_FAR_EYE) {
            return ray_mistakes[m].says;
        }
    }
    return NULL;
}

// The same of pixel number i, the first one that is wrong.
static const char *direction_looks(const Job04 *job, int i, const PixelAnswer *answers)
{
    const PixelJob *in = &job->pixels[i];
    // A sum with the eye rounds to the eye's digits.
    const double eye_error = 4 * 0x1p-24 * vec3_length(in->camera.eye);
    if (i >= FIRST_FAR_EYE) {
        return is_direction(unit_of(answers[i].direction), ray_of(in, &right).direction, eye_error)
                   ? "from a near eye it is right, from a far eye its digits are lost: the eye, a "
                     "large number, has no part in the direction"
                   : NULL;
    }
    return directions_look(job, answers);
}

// ---- Judging ------------------------------------------------------------------------------------

// A wrong direction.
//   remark   joins what was found
static Diagnosis describe_direction(const PixelJob *in, Vec3 found, const char *remark, Cause cause)
{
    const OracleVector e = ray_of(in, &right).direction;
    return diagnosis_of(
        message_new("pixel (%d, %d) of %dx%d: found direction %s of length %.6g, expected %s%s",
                    in->x, in->y, in->width, in->height, words_vec3(found, 6).text,
                    vec3_length(found), words_xyz(e.x, e.y, e.z, 6).text, remark),
        cause);
}

// Is a ray's direction right, of any length?
static Diagnosis transform_fault(const void *job, int i, const void *answers)
{
    const PixelJob *in = &((const Job04 *)job)->pixels[i];
    const Vec3 found = ((const PixelAnswer *)answers)[i].direction;
    const OracleRay ray = ray_of(in, &right);
    const double length = vec3_length(found);
    const Vec3 unit = {(float)(found.x / length), (float)(found.y / length),
                       (float)(found.z / length)};
    if (length == 0) {
        return describe_direction(in, found, "", (Cause){.says = "it is zero"});
    }
    if (is_near_04(unit, ray.direction, ray.direction_error)) {
        return NOTHING_WRONG;
    }
    return describe_direction(in, found, "", (Cause){.says = direction_looks(job, i, answers)});
}

static Diagnosis unit_fault(const void *job, int i, const void *answers)
{
    static const Cause not_unit = {
        .says = "it must be a unit vector, so that t is a distance: normalize()"};
    const Vec3 found = ((const PixelAnswer *)answers)[i].direction;
    return fabs(vec3_length(found) - 1) <= DISPLAY_ERROR_04
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
                        : own->t_min != 0 ? "what is before the eye counts from 0 on"
                        : own->t_max == FLT_MAX
                            ? "the largest float is an end, too: t_max is INFINITY"
                        : own->t_max != INFINITY ? "the ray has no end: t_max is INFINITY"
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
