// Lab 04: pictures of directions, in double precision, and what mistakes make of them. See
// judge_04.h.
#include "judge_04.h"

#include <math.h>

static const OracleRules3D right = {0};

// How far the colours of a mistake may be off: with the eye in them their rounding is that of it.
#define GUESS_ERROR 1e-5f

// The ray of a pixel, right or of the stub.
typedef OracleRay RayOf(const SceneJob3D *scene, int x, int y);

static OracleRay right_ray(const SceneJob3D *scene, int x, int y)
{
    return oracle3d_primary_ray(&scene->camera, x, y, scene->width, scene->height, &right);
}

static OracleRay ray_alone(const SceneJob3D *scene, int x, int y)
{
    const Vec3 direction = stub_direction_04(scene, x, y);
    return oracle3d_given_ray(direction, direction, 0);
}

// What direction_color writes for a pixel of the scene, with a mistake; alpha is 1.
typedef OracleVector ColorOf(const SceneJob3D *scene, int x, int y, RayOf *ray_of);

static OracleVector mapped(OracleVector direction)
{
    const OracleVector half = {0.5, 0.5, 0.5};
    return vector_plus(vector_scaled(0.5, direction), half);
}

static OracleVector direction_color(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    return mapped(ray_of(scene, x, y).direction);
}

static OracleVector unmapped(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    return ray_of(scene, x, y).direction;
}

static OracleVector absolute(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    const OracleVector d = ray_of(scene, x, y).direction;
    return (OracleVector){fabs(d.x), fabs(d.y), fabs(d.z)};
}

static OracleVector positive(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    const OracleVector d = ray_of(scene, x, y).direction;
    return (OracleVector){fmax(d.x, 0), fmax(d.y, 0), fmax(d.z, 0)};
}

static OracleVector half_halved(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    const OracleVector quarter = {0.25, 0.25, 0.25};
    return vector_minus(direction_color(scene, x, y, ray_of), quarter);
}

static OracleVector half_forgotten(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    return vector_scaled(0.5, ray_of(scene, x, y).direction);
}

static OracleVector unhalved(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    const OracleVector half = {0.5, 0.5, 0.5};
    return vector_plus(ray_of(scene, x, y).direction, half);
}

static OracleVector halved_late(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    return vector_scaled(2, direction_color(scene, x, y, ray_of));
}

static OracleVector turned_round(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    return mapped(vector_scaled(-1, ray_of(scene, x, y).direction));
}

static OracleVector of_point(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    const OracleRay ray = ray_of(scene, x, y);
    return mapped(vector_plus(ray.origin, ray.direction));
}

static OracleVector of_swapped_size(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    SceneJob3D other = *scene;
    other.width = scene->height, other.height = scene->width;
    return direction_color(&other, x, y, ray_of);
}

static OracleVector of_8_bits(const SceneJob3D *scene, int x, int y, RayOf *ray_of)
{
    const OracleVector c = vector_scaled(255, direction_color(scene, x, y, ray_of));
    return (OracleVector){floor(c.x) / 255, floor(c.y) / 255, floor(c.z) / 255};
}

static const struct {
    ColorOf *color;
    Cause cause;
} mistakes[] = {
    {unmapped, {.says = "as if the directions were the colours: -1 to 1 becomes 0 to 1"}},
    {absolute, {.says = "as if the absolute value were the colour: -1 becomes 0, and 0 a half"}},
    {positive, {.says = "as if negative parts were cut off: -1 becomes 0, and 0 a half"}},
    {half_halved, {.says = "as if the half were added before halving"}},
    {half_forgotten, {.says = "as if the half were not added"}},
    {unhalved, {.says = "as if only the half were added: from -1 to 1 is twice as far as 0 to 1"}},
    {halved_late, {.says = "as if 1 were added and the sum not halved: 1 becomes 2"}},
    {turned_round,
     {.says = "as if the direction were turned round: -1 becomes 1, and 1 becomes 0"}},
    {of_point, {.says = "as if the eye were added: the colour is that of the direction only"}},
    {of_8_bits, {.says = "as if colours were rounded to 8 bits: the image holds floats"}},
    {of_swapped_size, {.says = "as if width and height were swapped in the call"}},
};

// Draw a picture of these colours.
static void draw(const SceneJob3D *scene, ColorOf *color, RayOf *ray_of, Image *image)
{
    float *pixel = image->pixels;
    for (int y = 0; y < scene->height; y++) {
        for (int x = 0; x < scene->width; x++, pixel += IMAGE_CHANNELS) {
            const OracleVector c = color(scene, x, y, ray_of);
            pixel[0] = (float)c.x, pixel[1] = (float)c.y, pixel[2] = (float)c.z, pixel[3] = 1;
        }
    }
}

static Cause draw_mistaken_by(const SceneJob3D *scene, int mistake, RayOf *ray_of, Image *guess,
                              float *tolerances)
{
    if (mistake >= COUNT(mistakes)) {
        return (Cause){0};
    }
    draw(scene, mistakes[mistake].color, ray_of, guess);
    for (int i = 0; i < guess->width * guess->height; i++) {
        tolerances[i] = GUESS_ERROR;
    }
    return mistakes[mistake].cause;
}

// As DrawMistaken of picture.h has it.
static Cause draw_mistaken(const void *scene, int mistake, Image *guess, float *tolerances)
{
    return draw_mistaken_by(scene, mistake, right_ray, guess, tolerances);
}

Cause draw_directions_alone_04(const void *scene, int mistake, Image *guess, float *tolerances)
{
    return draw_mistaken_by(scene, mistake, ray_alone, guess, tolerances);
}

int expect_directions_04(const SceneJob3D *scene, ExpectedPicture *expected)
{
    if (image_create(scene->width, scene->height, &expected->reference) != 0) {
        return -1;
    }
    expected->background[3] = 1;
    // Half of the direction's, and the rounding of product and sum.
    expected->tolerance = (float)(right_ray(scene, 0, 0).direction_error / 2 + 2 * 0x1p-24);
    expected_picture_recognise(expected, draw_mistaken, scene);
    draw(scene, direction_color, right_ray, &expected->reference);
    return 0;
}
