// Lab 04: each task's answer tried alone. See judge_04.h and tests/stubs/.
//
// camera_axes and pixel_on_display need no other task. primary_ray is tried beside a display of
// which each point tells the arguments, direction_color beside rays that look along the camera's
// axes.
#include "judge_04.h"

#include "alone_picture.h"
#include "oracle3d.h"

#include <math.h>
#include <string.h>

// As on the device, for the stubs.
typedef Vec3 float3;
typedef struct Ray {
    float3 origin, direction;
    float t_min, t_max;
} Ray;

// The hole of pixel_on_display while another task is tried.
static float3 stub_display(int x, int y, int width, int height, float fov)
{
#include "04-camera-rays/pixel_on_display.cl"
}

// The hole of primary_ray, with what the function has around it.
static Ray stub_ray(int x, int y, int width, int height, Camera camera)
{
    Ray ray;
#include "04-camera-rays/primary_ray.cl"
    return ray;
}

Vec3 stub_display_04(const PixelJob *in)
{
    return stub_display(in->x, in->y, in->width, in->height, in->camera.fov);
}

Vec3 stub_direction_04(const SceneJob3D *scene, int x, int y)
{
    return stub_ray(x, y, scene->width, scene->height, scene->camera).direction;
}

// How far the direction of a right ray may be off: three products and two sums of numbers no longer
// than it is, and a normalisation, of few roundings of 2^-24 each. As in oracle3d.c.
#define TURN_ERROR (32 * 0x1p-24)

// A colour is a product and a sum of numbers below 2; the direction, already a unit vector, may be
// made one again.
#define COLOR_ERROR (4 * 0x1p-24f)

static OracleVector unit(double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    return (OracleVector){x / length, y / length, z / length};
}

// What the view transform makes of the stub's point: each axis as often as the point says.
static OracleVector turned(const PixelJob *in)
{
    const Vec3 p = stub_display_04(in);
    const Vec3 right = in->camera.right, up = in->camera.up, forward = in->camera.forward;
    const double x = p.x, y = p.y, z = p.z;
    return unit(x * right.x + y * up.x + z * forward.x, x * right.y + y * up.y + z * forward.y,
                x * right.z + y * up.z + z * forward.z);
}

// Is this its direction, of any length? No number is near one that is none.
static int is_turned(const PixelJob *in, Vec3 found)
{
    const OracleVector own = unit(found.x, found.y, found.z), expected = turned(in);
    return fabs(own.x - expected.x) <= TURN_ERROR && fabs(own.y - expected.y) <= TURN_ERROR &&
           fabs(own.z - expected.z) <= TURN_ERROR;
}

int are_turned_04(const void *job, const JudgeCheck *check, const Sections *answers)
{
    const PixelAnswer *found = function_answers(check->function, answers);
    int are_right = found != NULL;
    for (int i = 0; are_right && i < N_ALL_PIXELS; i++) {
        are_right = is_turned(&((const Job04 *)job)->pixels[i], found[i].direction);
    }
    return are_right;
}

// The colour of the stub's direction. As ColorAt of alone_picture.h has it.
static void direction_color(const void *pointer, int x, int y, float color[4])
{
    const SceneJob3D *scene = pointer;
    const Ray ray = stub_ray(x, y, scene->width, scene->height, scene->camera);
    color[0] = 0.5f * ray.direction.x + 0.5f;
    color[1] = 0.5f * ray.direction.y + 0.5f;
    color[2] = 0.5f * ray.direction.z + 0.5f;
    color[3] = 1;
}

int is_drawn_04(const void *job, int k, const Sections *answers)
{
    const SceneJob3D *scene = &((const Job04 *)job)->scenes[k];
    return alone_picture_is_right(answers, k, scene->width, scene->height, COLOR_ERROR,
                                  direction_color, scene);
}

static int expect_alone(const void *job, int k, ExpectedPicture *expected)
{
    const SceneJob3D *scene = &((const Job04 *)job)->scenes[k];
    expected->background[3] = 1;
    expected_picture_recognise(expected, draw_directions_alone_04, scene);
    return alone_picture_expect(scene->width, scene->height, COLOR_ERROR, direction_color, scene,
                                expected);
}

Cause drawn_cause_04(const void *job, const JudgeCheck *check, const Sections *answers)
{
    return alone_pictures_look(job, check->range.first, check->range.n, expect_alone, answers);
}

int write_alone_04(const void *pointer, const char *task, FILE *file)
{
    const Job04 *job = pointer;
    int result = 0;
    for (int k = 0; strcmp(task, "direction_color") == 0 && result == 0 && k < N_PICTURES; k++) {
        result = job_section_write(file, k, NULL, &job->scenes[k], sizeof job->scenes[k]);
    }
    return result;
}
