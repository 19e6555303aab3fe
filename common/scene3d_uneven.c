// Two scenes whose spheres do not stand where the room is: clusters, and a teapot in a stadium.
//
// A kd-tree that cuts cells in the middle spends its levels on the empty room (lab 08). Everything
// is drawn as a whole number and divided once, which rounds the same on every machine. Read next:
// scene3d_random.c.
#include "random.h"
#include "scene3d.h"

// Coordinates and radii are whole numbers of 2^-20.
#define STEPS (1 << 20)

// A number from lowest to highest, rounded to STEPS.
static float random_step(Random *random, double lowest, double highest)
{
    return (float)random_integer(random, (int64_t)(lowest * STEPS), (int64_t)(highest * STEPS)) /
           STEPS;
}

// A point whose coordinates are at most `reach` from those of the middle, and more often near.
static Vec3 random_near(Random *random, Vec3 middle, double reach)
{
    const float x = random_step(random, -reach, reach) / 2 + random_step(random, -reach, reach) / 2;
    const float y = random_step(random, -reach, reach) / 2 + random_step(random, -reach, reach) / 2;
    const float z = random_step(random, -reach, reach) / 2 + random_step(random, -reach, reach) / 2;
    return (Vec3){middle.x + x, middle.y + y, middle.z + z};
}

// Make room, with lights and twelve colours.
static int begin(int n_spheres, Vec3 from, Scene3D *scene)
{
    enum { N_COLORS = 12 };
    const Vec3 lights[] = {{4, -3, 5}, {2, 6, 3}, {-5, 1, 6}};
    const int n_lights = sizeof lights / sizeof lights[0];
    if (scene3d_create(n_spheres, N_COLORS, n_lights, from, scene) != 0) {
        return -1;
    }
    scene->background = (Vec3){0.05f, 0.08f, 0.2f};
    for (int i = 0; i < n_lights; i++) {
        scene->lights[i] = (Light){lights[i], scene3d_light_color(n_lights)};
    }
    for (int i = 0; i < N_COLORS; i++) {
        const Vec3 color = {(float)(3 + i % 3) / 5, (float)(2 + i % 4) / 5, (float)(5 - i / 3) / 5};
        scene->materials[i] = (Material){color, 0.8f, 0.2f, 30, 0, 1};
    }
    return 0;
}

int scene3d_clusters(int n_spheres, uint64_t seed, Scene3D *scene)
{
    enum { N_CLUSTERS = 8 };
    if (begin(n_spheres, (Vec3){3.5f, 2.2f, 2.2f}, scene) != 0) {
        return -1;
    }
    Random random = {seed};
    Vec3 middles[N_CLUSTERS];
    for (int c = 0; c < N_CLUSTERS; c++) {
        middles[c] = random_near(&random, (Vec3){0, 0, 0}, 1);
    }
    float min_radius, max_radius;
    scene3d_default_radii(n_spheres, &min_radius, &max_radius);
    for (int i = 0; i < n_spheres; i++) {
        const Vec3 at = random_near(&random, middles[i % N_CLUSTERS], 0.125);
        // A heap is an eighth of the room that these radii are for.
        const float radius = random_step(&random, min_radius / 8.0, max_radius / 8.0);
        scene->spheres[i] = (Sphere){at.x, at.y, at.z, radius};
    }
    return 0;
}

int scene3d_stadium(int n_spheres, uint64_t seed, Scene3D *scene)
{
    // The teapot stands on the field, which is at z = 0; one looks at it from beside it.
    const Vec3 teapot = {0, 0, 0.03125f};
    if (begin(n_spheres, (Vec3){0.125f, 0.0625f, 0.0625f}, scene) != 0) {
        return -1;
    }
    scene->view.at = teapot;
    Random random = {seed};
    for (int i = 0; i < n_spheres; i++) {
        Sphere *sphere = &scene->spheres[i];
        if (i % 10 != 0) {
            const Vec3 at = random_near(&random, teapot, 0.03125);
            *sphere = (Sphere){at.x, at.y, at.z, random_step(&random, 1.0 / 2048, 1.0 / 512)};
            continue;
        }
        // The stands: a box without a lid, rising outwards.
        const float across = random_step(&random, 2, 3), along = random_step(&random, -3, 3);
        const float side = i / 10 % 2 ? 1 : -1;
        const float x = i / 20 % 2 ? across * side : along, y = i / 20 % 2 ? along : across * side;
        *sphere = (Sphere){x, y, across - 2, random_step(&random, 1.0 / 32, 1.0 / 8)};
    }
    return 0;
}
