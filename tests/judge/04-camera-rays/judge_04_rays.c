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

static OracleRay ray_of(const PixelJob *in)
{
    return oracle3d_primary_ray(&in->camera, in->x, in->y, in->width, in->height, &right);
}

// ---- The direction ------------------------------------------------------------------------------

#define GIVEN                                                                                      \
    const PixelJob *in = &((const Job04 *)job)->pixels[i];                                         \
    const Vec3 found = ((const PixelAnswer *)answers)[i].direction

// Does a direction, of any length, go along a vector?
static int goes_along(Vec3 found, OracleVector vector, double error)
{
    const OracleVector off = vector_minus(vector_unit(vector_of(found)), vector_unit(vector));
    return vector_length(off) <= 2 * error;
}

// A mistake explains every direction but those of the far eyes: with them sums lose digits.
#define IS_FOUND(vector)                                                                           \
    (i >= FIRST_FAR_EYE || goes_along(found, vector, ray_of(in).direction_error))

// The point on the display, with another fov and size.
static OracleVector display(const PixelJob *in, double fov, int width, int height)
{
    return oracle3d_display(in->x, in->y, width, height, fov, &right);
}

// A point as seen from the eye, turned to the scene's axes.
static OracleVector turned_by(const Camera *camera, OracleVector p)
{
    const OracleVector x = vector_scaled(p.x, vector_of(camera->right));
    const OracleVector y = vector_scaled(p.y, vector_of(camera->up));
    return vector_plus(vector_plus(x, y), vector_scaled(p.z, vector_of(camera->forward)));
}

// And the other way round.
static OracleVector turned_back(const Camera *camera, OracleVector p)
{
    return (OracleVector){vector_dot(p, vector_of(camera->right)),
                          vector_dot(p, vector_of(camera->up)),
                          vector_dot(p, vector_of(camera->forward))};
}

// The point on the display, as pixel_on_display has it, or its stub.
static OracleVector display_of(const Job *job, const PixelJob *in)
{
    return job->is_alone ? vector_of(stub_display_04(in))
                         : display(in, in->camera.fov, in->width, in->height);
}

static OracleVector with_unit_sides(OracleVector p)
{
    p.z = 0;
    p = vector_unit(p);
    p.z = 1;
    return p;
}

// The direction that a right ray has.
static OracleRay expected_ray(const Job *job, const PixelJob *in)
{
    OracleRay ray = ray_of(in);
    if (job->is_alone) {
        ray.direction = vector_unit(turned_by(&in->camera, display_of(job, in)));
    }
    return ray;
}

// Is a ray's direction right, of any length?
static int is_turned(const Job *job, const PixelJob *in, Vec3 found)
{
    const OracleRay ray = expected_ray(job, in);
    const double length = vec3_length(found);
    const Vec3 unit = {(float)(found.x / length), (float)(found.y / length),
                       (float)(found.z / length)};
    return length != 0 && is_near_04(unit, ray.direction, ray.direction_error);
}

RIGHT(is_right_direction, is_turned(job, in, found))
RIGHT(is_unit, fabs(vec3_length(found) - 1) <= DISPLAY_ERROR_04)

// The direction of another pixel or picture.
static OracleVector of_other(const Job *job, const PixelJob *in, i32 x, i32 y, i32 width,
                             i32 height)
{
    PixelJob other = *in;
    other.x = x, other.y = y, other.width = width, other.height = height;
    return turned_by(&in->camera, display_of(job, &other));
}

// Along other axes than the camera's.
static OracleVector along(OracleVector p, Vec3 right, Vec3 up, Vec3 forward)
{
    return turned_by(&(Camera){.right = right, .up = up, .forward = forward}, p);
}

static double sign_of(double number)
{
    return number > 0 ? 1 : -1;
}

KNOWN_LIST(known_of_direction)
{
    GIVEN;
    const Camera *camera = &in->camera;
    const OracleVector p = display_of(job, in);
    const int is_middle = 2 * in->x + 1 == in->width && 2 * in->y + 1 == in->height;

    ANSWERS(
        turned_round, turned_back(camera, p),
        "the view transform is turned round: x times right plus y times up plus z times forward");
    ANSWERS(backwards, vector_scaled(-1, turned_by(camera, p)), "it points backwards");
    ANSWERS(unturned, p, "it is still in the camera's axes: they are to turn it to the scene's");
    ANSWERS(with_the_eye, vector_plus(vector_of(camera->eye), turned_by(camera, p)),
            "the eye was added: that makes a point, and a direction has no place");
    ANSWERS(with_fov_1, turned_by(camera, display(in, 1, in->width, in->height)),
            "that is the direction of a fov of 1, not the camera's");
    ANSWERS(up_is_down, turned_by(camera, (OracleVector){p.x, -p.y, 1}), "up and down are swapped");
    EACH(no_forward, is_middle || IS_FOUND(turned_by(camera, (OracleVector){p.x, p.y, 0})),
         "forward has no part in it: x times right plus y times up plus z times forward");
    ANSWERS(right_and_up_swapped, turned_by(camera, (OracleVector){p.y, p.x, p.z}),
            "right and up are swapped: x goes along right, y along up");
    ANSWERS(right_is_left, turned_by(camera, (OracleVector){-p.x, p.y, p.z}),
            "right and left are swapped");
    ANSWERS(without_right, turned_by(camera, (OracleVector){0, p.y, p.z}),
            "right has no part in it: x times right is missing");
    ANSWERS(without_up, turned_by(camera, (OracleVector){p.x, 0, p.z}),
            "up has no part in it: y times up is missing");
    ANSWERS(x_twice, turned_by(camera, (OracleVector){p.x, p.x, p.z}),
            "up was multiplied by x: y goes along up");
    ANSWERS(y_twice, turned_by(camera, (OracleVector){p.y, p.y, p.z}),
            "right was multiplied by y: x goes along right");
    ANSWERS(forward_twice, turned_by(camera, (OracleVector){p.x, p.y, 2 * p.z}),
            "forward was added twice");
#define AXIS_TWICE "one of the camera's axes is there twice, and another is missing"
    ANSWERS(right_for_up, along(p, camera->right, camera->right, camera->forward), AXIS_TWICE);
    ANSWERS(up_for_right, along(p, camera->up, camera->up, camera->forward), AXIS_TWICE);
    ANSWERS(up_for_forward, along(p, camera->right, camera->up, camera->up), AXIS_TWICE);
    ANSWERS(right_for_forward, along(p, camera->right, camera->up, camera->right), AXIS_TWICE);
    ANSWERS(forward_for_up, along(p, camera->right, camera->forward, camera->forward), AXIS_TWICE);
    ANSWERS(forward_for_right, along(p, camera->forward, camera->up, camera->forward), AXIS_TWICE);
    ANSWERS(without_the_eye, vector_minus(turned_by(camera, p), vector_of(camera->eye)),
            "the eye was taken off: that makes a point, and a direction has no place");

    ANSWERS(with_swapped_size, of_other(job, in, in->x, in->y, in->height, in->width),
            "width and height are swapped");
    ANSWERS(swapped_pixel, of_other(job, in, in->y, in->x, in->width, in->height),
            "x and y are swapped in the call of pixel_on_display");
#define ONE_SIZE "width or height is there twice in the call of pixel_on_display"
    ANSWERS(width_twice, of_other(job, in, in->x, in->y, in->width, in->width), ONE_SIZE);
    ANSWERS(height_twice, of_other(job, in, in->x, in->y, in->height, in->height), ONE_SIZE);
    ANSWERS(looks_back, turned_by(camera, (OracleVector){p.x, p.y, -p.z}),
            "forward is taken off: the display is before the eye");

    // Of 0 no unit vector comes.
    EACH(each_unit,
         p.x == 0 || p.y == 0 ||
             IS_FOUND(turned_by(camera, (OracleVector){sign_of(p.x), sign_of(p.y), 1})),
         "each part was made a unit vector by itself: the sum of all three is to be made one");
    // In the very middle there is no such part.
    EACH(unit_sides, is_middle || IS_FOUND(turned_by(camera, with_unit_sides(p))),
         "the part along the display was made a unit vector before forward was added");
    // A sum with the eye rounds to the eye's digits.
    ONLY(far_eye,
         i >= FIRST_FAR_EYE && goes_along(found, expected_ray(job, in).direction,
                                          4 * 0x1p-24 * vec3_length(camera->eye)),
         "from a near eye it is right, from a far eye its digits are lost: the eye, a large "
         "number, has no part in the direction");
    ONLY(is_zero, vec3_length(found) == 0, "it is zero");
    return NO_MORE;
}

KNOWN_LIST(known_of_length)
{
    (void)job, (void)i, (void)answers;
    ONLY(not_unit, 1, "it must be a unit vector, so that t is a distance: normalize()");
    return NO_MORE;
}

static char *describe_direction(const void *job, int i, const void *answers)
{
    GIVEN;
    const OracleVector e = ray_of(in).direction;
    return message_new("pixel (%d, %d) of %dx%d: found direction %s of length %.6g, expected %s",
                       in->x, in->y, in->width, in->height, words_vec3(found, 6).text,
                       vec3_length(found), words_xyz(e.x, e.y, e.z, 6).text);
}

const Function ray_transform_04 = {
    "pixels",
    N_ALL_PIXELS,
    sizeof(PixelAnswer),
    KNOWING(is_right_direction, describe_direction, known_of_direction),
    .counted = "rays",
    .knows_constant = 1};
const Function ray_unit_04 = {"pixels",
                              N_ALL_PIXELS,
                              sizeof(PixelAnswer),
                              KNOWING(is_unit, describe_direction, known_of_length),
                              .counted = "rays",
                              .knows_constant = 1};
#undef GIVEN

// ---- Where a ray begins and ends ----------------------------------------------------------------

#define GIVEN                                                                                      \
    const PixelJob *in = &((const Job04 *)job)->pixels[i];                                         \
    const PixelAnswer *found = (const PixelAnswer *)answers + i

static int begins_at(const PixelAnswer *found, Vec3 eye)
{
    return found->origin.x == eye.x && found->origin.y == eye.y && found->origin.z == eye.z;
}

RIGHT(has_right_limits,
      begins_at(found, in->camera.eye) && found->t_min == 0 && found->t_max == INFINITY)

KNOWN_LIST(known_of_limits)
{
    GIVEN;
    const int begins = begins_at(found, in->camera.eye);

    ONLY(not_at_eye, !begins, "the ray begins at the eye");
    ONLY(not_from_0, found->t_min != 0, "what is before the eye counts from 0 on");
    ONLY(largest_float, found->t_max == FLT_MAX,
         "the largest float is an end, too: t_max is INFINITY");
    ONLY(has_end, found->t_max != INFINITY, "the ray has no end: t_max is INFINITY");
    return NO_MORE;
}

static char *describe_limits(const void *job, int i, const void *answers)
{
    GIVEN;
    return message_new(
        "pixel (%d, %d) of %dx%d: found origin %s, t_min %g, t_max %g, expected %s, 0 and inf",
        in->x, in->y, in->width, in->height, words_vec3(found->origin, 6).text, found->t_min,
        found->t_max, words_vec3(in->camera.eye, 6).text);
}

const Function ray_limits_04 = {"pixels",
                                N_ALL_PIXELS,
                                sizeof(PixelAnswer),
                                KNOWING(has_right_limits, describe_limits, known_of_limits),
                                .counted = "rays",
                                .knows_constant = 1};
