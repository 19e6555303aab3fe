// common/scene3d_sphereflake, _random and _lattice: where their spheres are, how large they are and
// from where they are seen.
#include "scene3d_samples.h"

TestSuite(scene3d_generators, .init = folder_enter, .fini = folder_leave);

// ---- Sphereflake --------------------------------------------------------------------------------

Test(scene3d_generators, sphereflake_has_a_ball_more_for_each_power_of_nine)
{
    static const int COUNTS[] = {1, 10, 91, 820, 7381, 66430};
    for (int size = 0; size < 6; size++) {
        Scene3D scene = {0};
        cr_assert_eq(scene3d_sphereflake(size, &scene), 0);
        cr_expect_eq(scene.n_spheres, COUNTS[size], "size %d: %d", size, scene.n_spheres);
        int n_with_size[6] = {0};
        for (int i = 0; i < scene.n_spheres; i++) {
            int level = (int)lround(-log(2 * (double)scene.spheres[i].radius) / log(3));
            cr_assert(level >= 0 && level <= size);
            cr_assert_eq(scene.spheres[i].radius, (float)(0.5 / pow(3, level)), "sphere %d", i);
            n_with_size[level]++;
        }
        for (int level = 0, n_expected = 1; level <= size; level++, n_expected *= 9) {
            cr_expect_eq(n_with_size[level], n_expected, "size %d, level %d", size, level);
        }
        scene3d_free(&scene);
    }
    Scene3D scene = scene_open("sphereflake");
    cr_expect_eq(scene.n_spheres, 7381);
    scene3d_free(&scene);
    scene = scene_open("sphereflake:size=1");
    cr_expect_eq(scene.n_spheres, 10);
    scene3d_free(&scene);
}

// Centres lie within 1 of the origin, so each coordinate is rounded by 3e-8 at most: a distance of
// two centres is off by less than this.
#define DISTANCE_ROUNDING 2e-7

// How far above the parent's middle a ball stands, seen along the direction from the parent's own
// parent; in units of the distance of the two centres.
static double height_above(const Sphere *ball, const Sphere *parent, const Sphere *grandparent)
{
    double dot = ((double)ball->x - parent->x) * ((double)parent->x - grandparent->x) +
                 ((double)ball->y - parent->y) * ((double)parent->y - grandparent->y) +
                 ((double)ball->z - parent->z) * ((double)parent->z - grandparent->z);
    return dot / distance_between(ball, parent) / distance_between(parent, grandparent);
}

// A ball is followed by its children, each with its own. Of every three children the first stands
// high on its parent, the others on its equator. Returns the index after them.
static int expect_children_stand(const Scene3D *scene, int grandparent, int parent, int size)
{
    const Sphere below = {0, 0, -1, 1};  // what the largest ball stands on
    const Sphere *balls = scene->spheres;
    int next = parent + 1;
    for (int i = 0; size > 0 && i < 9; i++) {
        double expected = size_of(scene, parent) * 4 / 3;
        double distance = distance_between(&balls[parent], &balls[next]);
        cr_assert(fabs(distance - expected) < DISTANCE_ROUNDING, "%d on %d: %g for %g", next,
                  parent, distance, expected);
        double height = height_above(&balls[next], &balls[parent],
                                     grandparent < 0 ? &below : &balls[grandparent]);
        double expected_height = i % 3 == 0 ? sqrt(2.0 / 3) : 0;
        cr_assert(fabs(height - expected_height) < 2 * DISTANCE_ROUNDING / expected,
                  "%d on %d stands at %g, not %g", next, parent, height, expected_height);
        next = expect_children_stand(scene, parent, next, size - 1);
    }
    return next;
}

Test(scene3d_generators, sphereflake_balls_touch_their_parents_and_stay_within_1)
{
    Scene3D scene = scene_open("sphereflake:size=5");
    cr_expect_eq(expect_children_stand(&scene, -1, 0, 5), scene.n_spheres);
    const Sphere origin = {0, 0, 0, 0};
    for (int i = 0; i < scene.n_spheres; i++) {
        double reach = distance_between(&scene.spheres[i], &origin) + size_of(&scene, i);
        cr_assert_leq(reach, 1 + DISTANCE_ROUNDING, "ball %d reaches %g", i, reach);
    }
    scene3d_free(&scene);
}

// The first ten, as the original program prints them: directions times 2/3.
Test(scene3d_generators, sphereflake_stands_as_the_original)
{
    static const float DIRECTIONS[9][3] = {
        {0.408248f, 0.408248f, 0.816497f},  {0.965926f, 0.258819f, 0},
        {0.258819f, 0.965926f, 0},          {-0.557678f, 0.149429f, 0.816497f},
        {-0.707107f, 0.707107f, 0},         {-0.965926f, -0.258819f, 0},
        {0.149429f, -0.557678f, 0.816497f}, {-0.258819f, -0.965926f, 0},
        {0.707107f, -0.707107f, 0},
    };
    Scene3D scene = scene_open("sphereflake:size=1");
    for (int i = 0; i < 9; i++) {
        const Sphere *sphere = &scene.spheres[i + 1];
        cr_expect(fabsf(sphere->x - DIRECTIONS[i][0] * 2 / 3) < 1e-6f &&
                      fabsf(sphere->y - DIRECTIONS[i][1] * 2 / 3) < 1e-6f &&
                      fabsf(sphere->z - DIRECTIONS[i][2] * 2 / 3) < 1e-6f,
                  "child %d", i);
    }
    cr_expect(scene.background.x == 0.078f && scene.background.z == 0.753f);
    cr_expect(scene.view.from.x == 2.1f && scene.view.from.y == 1.3f && scene.view.from.z == 1.7f);
    cr_expect(scene.view.angle == 45 && scene.view.hither == 0.01f);
    cr_expect(scene.n_lights == 3 && scene.lights[1].position.y == -4);
    scene3d_free(&scene);
}

// Haines' count: of the 513 x 513 rays of his picture none ends in the background. What misses the
// balls hits the floor, 24 x 24 at z = -1/2, which this course leaves out.
Test(scene3d_generators, sphereflake_is_seen_from_where_every_ray_would_hit_its_floor)
{
    Scene3D scene = scene_open("sphereflake:size=0");
    const Axes axes = axes_of(&scene.view);
    const double spacing = (double)scene3d_fov(&scene.view, 513, 513) / 513;
    int n_missed = 0;
    for (int y = -256; y <= 256; y++) {
        for (int x = -256; x <= 256; x++) {
            double ray[3];
            ray_towards(&axes, spacing, x, y, ray);
            double t = (-0.5 - scene.view.from.z) / ray[2];
            double floor_x = scene.view.from.x + t * ray[0];
            double floor_y = scene.view.from.y + t * ray[1];
            n_missed += !(t > 0 && fabs(floor_x) <= 12 && fabs(floor_y) <= 12);
        }
    }
    cr_expect_eq(n_missed, 0, "%d rays", n_missed);
    scene3d_free(&scene);
}

// ---- Random and lattice -------------------------------------------------------------------------

static void expect_random(const Scene3D *scene, float min_radius, float max_radius)
{
    const float centre_step = 1.0f / (1 << 20);
    const float radius_step = 1.0f / (1 << 24);
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere *sphere = &scene->spheres[i];
        cr_assert(fabsf(sphere->x) <= 1 && fabsf(sphere->y) <= 1 && fabsf(sphere->z) <= 1);
        cr_assert(is_multiple(sphere->x, centre_step) && is_multiple(sphere->y, centre_step) &&
                  is_multiple(sphere->z, centre_step));
        cr_assert(sphere->radius >= min_radius - radius_step / 2 &&
                      sphere->radius <= max_radius + radius_step / 2,
                  "sphere %d: radius %g", i, (double)sphere->radius);
    }
}

Test(scene3d_generators, random_takes_its_arguments_in_any_order)
{
    Scene3D scene = scene_open("random:max=0.5,n=500,min=0.25,seed=3");
    cr_assert_eq(scene.n_spheres, 500);
    expect_random(&scene, 0.25f, 0.5f);
    float smallest = INFINITY, largest = 0, lowest = INFINITY, highest = -INFINITY;
    for (int i = 0; i < 500; i++) {
        smallest = fminf(smallest, scene.spheres[i].radius);
        largest = fmaxf(largest, scene.spheres[i].radius);
        lowest = fminf(lowest, scene.spheres[i].z);
        highest = fmaxf(highest, scene.spheres[i].z);
        cr_assert_eq(scene.material_ids[i], (u32)i, "each its own colour");
    }
    cr_expect(smallest < 0.26f && largest > 0.49f, "%g to %g", (double)smallest, (double)largest);
    cr_expect(lowest < -0.98f && highest > 0.98f, "%g to %g", (double)lowest, (double)highest);
    scene3d_free(&scene);

    scene = scene_open("random:n=0");
    cr_expect(scene.n_spheres == 0 && scene.spheres == NULL && scene.n_lights > 0);
    scene3d_free(&scene);
    scene = scene_open("random:n=9,min=1e-6,max=1e-6");
    cr_expect_float_eq(scene.spheres[0].radius, 1e-6f, 3e-8f);
    scene3d_free(&scene);
    scene = scene_open("random:n=9,min=1000,max=1000");
    cr_expect_eq(scene.spheres[8].radius, 1000);
    scene3d_free(&scene);
    scene = scene_open("random:n=8,max=2");  // the smallest stays that of 8 spheres
    expect_random(&scene, 0.1f, 2);
    scene3d_free(&scene);
}

Test(scene3d_generators, default_radii_are_shares_of_the_spacing)
{
    static const struct {
        int n_spheres;
        float min_radius, max_radius;
    } EXPECTED[] = {{0, 0.2f, 0.8f},
                    {1, 0.2f, 0.8f},
                    {8, 0.1f, 0.4f},
                    {1000, 0.02f, 0.08f},
                    {1000000, 0.002f, 0.008f},
                    {8000000, 0.001f, 0.004f},
                    {10000000, 0.000928f, 0.003713f}};
    for (size_t i = 0; i < sizeof EXPECTED / sizeof EXPECTED[0]; i++) {
        float min_radius, max_radius;
        scene3d_default_radii(EXPECTED[i].n_spheres, &min_radius, &max_radius);
        cr_expect_float_eq(min_radius, EXPECTED[i].min_radius, 1e-6f, "n=%d",
                           EXPECTED[i].n_spheres);
        cr_expect_float_eq(max_radius, EXPECTED[i].max_radius, 1e-6f, "n=%d",
                           EXPECTED[i].n_spheres);
    }
}

Test(scene3d_generators, a_million_random_spheres)
{
    Scene3D scene = scene_open("random:n=1000000");
    cr_assert_eq(scene.n_spheres, 1000000);
    expect_random(&scene, 0.002f, 0.008f);
    scene3d_free(&scene);
}

// All of the cube fits into the picture, whichever way it is turned.
Test(scene3d_generators, random_and_lattice_are_seen_as_a_whole)
{
    static const char *const NAMES[] = {"random", "lattice"};
    for (int i = 0; i < 2; i++) {
        Scene3D scene = scene_open(NAMES[i]);
        const Vec3 from = scene.view.from;
        double distance = sqrt((double)vec3_dot(from, from));
        cr_expect_geq(distance * sin(scene.view.angle / 2 * M_PI / 180), sqrt(3), "%s", NAMES[i]);
        cr_expect(scene.view.at.x == 0 && scene.view.at.y == 0 && scene.view.at.z == 0);
        scene3d_free(&scene);
    }
}

Test(scene3d_generators, lattice_spheres_are_equal_and_apart)
{
    Scene3D scene = scene_open("lattice:n=4");
    cr_assert_eq(scene.n_spheres, 64);
    for (int i = 0; i < 64; i++) {
        const Sphere *sphere = &scene.spheres[i];
        cr_expect_eq(sphere->radius, scene.spheres[0].radius);
        cr_expect(fabsf(sphere->x) + sphere->radius <= 1 && fabsf(sphere->y) <= 0.75f &&
                  fabsf(sphere->z) <= 0.75f);
        for (int j = 0; j < i; j++) {
            cr_expect_gt(distance_between(sphere, &scene.spheres[j]), 2 * size_of(&scene, i));
        }
    }
    cr_expect(scene.spheres[0].x == -0.75f && scene.spheres[63].z == 0.75f);
    scene3d_free(&scene);
    scene = scene_open("lattice");
    cr_expect_eq(scene.n_spheres, 1000);
    scene3d_free(&scene);
}
