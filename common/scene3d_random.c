// The random scene (scene3d_random() of scene3d.h).
//
// Everything is drawn as a whole number and divided once, which rounds the same on every machine.
// Read next: random.h.
#include "random.h"
#include "scene3d.h"

#include <math.h>

// Centres are whole numbers of 2^-20: any of them is exact in float, and so is a difference of two.
#define CENTRE_STEPS (1 << 20)
// Radii are whole numbers of 2^-24: fine enough for SCENE3D_MIN_RADIUS.
#define RADIUS_STEPS (1 << 24)

// Of the spacing of spheres: the smallest leave the view free, the largest do not quite touch.
#define SMALLEST_SHARE 0.1
#define LARGEST_SHARE 0.4

#define DARKEST_COLOUR 64  // of 255: spheres stand out from the background
#define BRIGHTEST_COLOUR 255

static float random_centre(Random *random)
{
    return (float)random_integer(random, -CENTRE_STEPS, CENTRE_STEPS) / CENTRE_STEPS;
}

static float random_colour(Random *random)
{
    return (float)random_integer(random, DARKEST_COLOUR, BRIGHTEST_COLOUR) / BRIGHTEST_COLOUR;
}

// Newton's method with the four operations only: cbrt() may differ in its last digit between
// machines. From n down to the root of 10 million takes 34 steps; more change nothing.
static double cube_root(double n)
{
    double root = n;
    for (int i = 0; i < 50; i++) {
        root = (2 * root + n / (root * root)) / 3;
    }
    return root;
}

void scene3d_default_radii(int n_spheres, float *min_radius, float *max_radius)
{
    // Each sphere has a small cube of the cube of side 2 for itself; the spacing is its side.
    double spacing = 2 / cube_root(n_spheres < 1 ? 1 : n_spheres);
    *min_radius = (float)(SMALLEST_SHARE * spacing);
    *max_radius = (float)(LARGEST_SHARE * spacing);
}

static void spheres_draw(Random *random, float min_radius, float max_radius, Scene3D *scene)
{
    int64_t min_steps = llroundf(min_radius * RADIUS_STEPS);
    int64_t max_steps = llroundf(max_radius * RADIUS_STEPS);
    for (int i = 0; i < scene->n_spheres; i++) {
        Sphere *sphere = &scene->spheres[i];
        sphere->x = random_centre(random);
        sphere->y = random_centre(random);
        sphere->z = random_centre(random);
        // In double, which is exact: gcc 14's vectors make a float of an int64_t's low 32 bits.
        const double steps = (double)random_integer(random, min_steps, max_steps);
        sphere->radius = (float)(steps / RADIUS_STEPS);

        Material *material = &scene->materials[i];
        material->color.x = random_colour(random);
        material->color.y = random_colour(random);
        material->color.z = random_colour(random);
        material->kd = 0.8f;
        material->ks = 0.2f;
        material->shine = 30;
        material->refraction = 1;
    }
}

int scene3d_random(int n_spheres, uint64_t seed, float min_radius, float max_radius, Scene3D *scene)
{
    // The eye sees a ball of radius sin(22.5 degrees) times its distance: 1.79. The cube's corners
    // are 1.73 away from its middle.
    const Vec3 from = {3.5f, 2.2f, 2.2f};
    const Vec3 lights[] = {{4, -3, 5}, {2, 6, 3}, {-5, 1, 6}};
    const int n_lights = sizeof lights / sizeof lights[0];
    if (scene3d_create(n_spheres, n_spheres, n_lights, from, scene) != 0) {
        return -1;
    }
    scene->background = (Vec3){0.05f, 0.08f, 0.2f};
    for (int i = 0; i < n_lights; i++) {
        scene->lights[i] = (Light){lights[i], scene3d_light_color(n_lights)};
    }
    Random random = {seed};
    spheres_draw(&random, min_radius, max_radius, scene);
    return 0;
}
