// judge/oracle3d_mirrors: right where right can be worked out by hand, and honest about how
// rounding grows from mirror to mirror.
#include "job_scene3d.h"
#include "oracle3d_mirrors.h"
#include "random3d.h"
#include "surroundings.h"

#include <math.h>

TestSuite(oracle3d_mirrors);

static const OracleMirrorRules RIGHT = {0};

// ---- By hand ------------------------------------------------------------------------------------

// Two balls that face each other along x, and a ray from between them: it meets the one at x = 2,
// then the one at x = -2, and so on. One light above, between them.
typedef struct Facing {
    Sphere spheres[2];
    u32 material_ids[2];
    Material materials[2];
    Light light;
    Scene3D scene;
} Facing;

static void face(Facing *facing)
{
    *facing = (Facing){.spheres = {{3, 0, 0, 1}, {-3, 0, 0, 1}}, .material_ids = {0, 1}};
    facing->materials[0] = (Material){.color = {1, 0.5f, 0}, .kd = 0.5f, .ks = 0.5f};
    facing->materials[1] = (Material){.color = {0, 1, 1}, .kd = 0.25f, .ks = 0.25f};
    facing->light = (Light){{0, 0, 0}, {1, 1, 1}};
    facing->scene = (Scene3D){.spheres = facing->spheres,
                              .material_ids = facing->material_ids,
                              .materials = facing->materials,
                              .lights = &facing->light,
                              .n_spheres = 2,
                              .n_materials = 2,
                              .n_lights = 1,
                              .background = {1, 1, 1}};
}

static OracleNear followed(const Facing *facing, int max_bounces, const OracleMirrorRules *rules)
{
    const OracleRay ray = {.direction = {1, 0, 0}, .direction_error = 0x1p-24};
    return oracle3d_follow(&facing->scene, ray, max_bounces, rules, NULL);
}

static void expect_color(OracleNear found, double r, double g, double b)
{
    cr_expect(fabs(found.value.x - r) < 1e-12 && fabs(found.value.y - g) < 1e-12 &&
                  fabs(found.value.z - b) < 1e-12,
              "found (%.9g, %.9g, %.9g), expected (%g, %g, %g)", found.value.x, found.value.y,
              found.value.z, r, g, b);
    cr_expect_lt(found.error, 1e-3);
}

Test(oracle3d_mirrors, light_counts_the_product_of_the_mirrors)
{
    Facing facing;
    face(&facing);
    // Each ball gives its kd times its colour: the light is straight above the point.
    expect_color(followed(&facing, 0, &RIGHT), 0.5, 0.25, 0);
    expect_color(followed(&facing, 1, &RIGHT), 0.5, 0.25 + 0.5 * 0.25, 0.5 * 0.25);
    const double third = 0.5 * 0.25;
    expect_color(followed(&facing, 2, &RIGHT), 0.5 + third * 0.5, 0.375 + third * 0.25, 0.125);
    const OracleMirrorRules unweighted = {.weight = WEIGHT_ONE};
    expect_color(followed(&facing, 1, &unweighted), 0.5, 0.5, 0.25);
}

Test(oracle3d_mirrors, what_is_before_a_light_takes_it_and_what_is_behind_does_not)
{
    Facing facing;
    face(&facing);
    facing.light.position = (Vec3){-1.5f, 0, 0};
    expect_color(followed(&facing, 0, &RIGHT), 0.5, 0.25, 0);
    const OracleMirrorRules endless = {.endless_light = 1};
    expect_color(followed(&facing, 0, &endless), 0, 0, 0);
    facing.light.position = (Vec3){-4.5f, 0, 0};
    expect_color(followed(&facing, 0, &RIGHT), 0, 0, 0);
    const OracleMirrorRules unshaded = {.no_shadows = 1};
    expect_color(followed(&facing, 0, &unshaded), 0.5, 0.25, 0);
}

Test(oracle3d_mirrors, a_miss_brings_the_background_by_its_weight)
{
    Facing facing;
    face(&facing);
    facing.scene.n_spheres = 1;
    expect_color(followed(&facing, 0, &RIGHT), 0.5, 0.25, 0);
    expect_color(followed(&facing, 5, &RIGHT), 1, 0.75, 0.5);
}

// How many rays that is: each hit of this scene has its one light before it.
static void expect_rays(const Facing *facing, int max_bounces, u32 n_traced, u32 n_hits)
{
    const OracleRay ray = {.direction = {1, 0, 0}, .direction_error = 0x1p-24};
    OracleRayCount count;
    oracle3d_follow(&facing->scene, ray, max_bounces, &RIGHT, &count);
    cr_expect(count.n_traced == n_traced && count.n_hits == n_hits && count.n_to_lights == n_hits &&
                  count.n_unsure == 0,
              "found %u traced, %u hits, %u to lights, %u unsure, expected %u, %u, %u and 0",
              count.n_traced, count.n_hits, count.n_to_lights, count.n_unsure, n_traced, n_hits,
              n_hits);
}

Test(oracle3d_mirrors, rays_are_counted_up_to_the_end)
{
    Facing facing;
    face(&facing);
    expect_rays(&facing, 0, 1, 1);
    expect_rays(&facing, 3, 4, 4);
    facing.scene.n_spheres = 1;
    expect_rays(&facing, 5, 2, 1);
}

Test(oracle3d_mirrors, of_lights_along_the_surface_rounding_decides)
{
    const Vec3 ways[] = {{0, 0, 1}, {1, 0, 0}, {1, 0, 0x1p-30f}, {1, 0, -0x1p-12f}};
    Light lights[4];
    for (int i = 0; i < 4; i++) {
        lights[i] = (Light){ways[i], {1, 1, 1}};
    }
    const OracleSides sides =
        oracle3d_sides(lights, 4, (OracleNear){{0}, 0}, (OracleNear){{0, 0, 1}, 0});
    cr_expect(sides.n_before == 3 && sides.n_unsure == 2, "found %u, %u", sides.n_before,
              sides.n_unsure);
}

// Where two balls overlap, between mirrors as far apart as their radius, errors grow slowly.
Test(oracle3d_mirrors, many_mirrors_can_be_followed)
{
    Facing facing;
    face(&facing);
    facing.spheres[0] = (Sphere){4, 0, 0, 8};
    facing.spheres[1] = (Sphere){-4, 0, 0, 8};
    facing.materials[0].ks = facing.materials[1].ks = 1;
    const OracleNear color = followed(&facing, 130, &RIGHT);
    // A quarter from each mirror and from where it ends.
    cr_expect_float_eq(color.value.y, 131 * 0.25, 1e-9, "found %g", color.value.y);
    // Who ends after 128 lacks two of them.
    cr_expect_lt(color.error, 0.25);
}

// ---- Rounding -----------------------------------------------------------------------------------

static OracleVector jittered(Random *random, OracleVector v, double error)
{
    const Vec3 by = random_point(random, 1);
    const double share = error / sqrt(3);
    return (OracleVector){v.x + share * by.x, v.y + share * by.y, v.z + share * by.z};
}

// Rays that start and go as far beside as they may, and what comes out beside: never more than the
// bound. This is what ambiguous pixels are for.
static void expect_bounded(JobScene3D *scene, Random *random, int *n_ambiguous, int *n_far)
{
    const Scene3D *s = &scene->scene;
    for (int pixel = 0; pixel < s->width * s->height; pixel++) {
        const OracleRay ray = job_scene3d_ray(scene, pixel);
        const OracleNear color = oracle3d_follow(s, ray, 3, &RIGHT, NULL);
        OracleRay beside = ray;
        beside.direction = jittered(random, ray.direction, ray.direction_error);
        const OracleNear other = oracle3d_follow(s, beside, 3, &RIGHT, NULL);
        if (isinf(color.error) || isinf(other.error)) {
            ++*n_ambiguous;
            continue;
        }
        const double off =
            fmax(fmax(fabs(other.value.x - color.value.x), fabs(other.value.y - color.value.y)),
                 fabs(other.value.z - color.value.z));
        *n_far += off > 1e-5;
        cr_assert_leq(off, color.error + other.error, "pixel %d: %g", pixel, off);
    }
}

Test(oracle3d_mirrors, a_ray_a_little_beside_stays_within_the_bound)
{
    Random random = {5};
    int n_ambiguous = 0, n_far = 0, n_rays = 0;
    for (int i = 0; i < 6; i++) {
        JobScene3D scene;
        cr_assert_eq(job_scene3d_random(&scene, &random, 24, 0.25f, 0.5f, 32, 24), 0);
        for (int k = 0; k < scene.scene.n_materials; k++) {
            scene.scene.materials[k].ks = 0.75f;
        }
        expect_bounded(&scene, &random, &n_ambiguous, &n_far);
        n_rays += 32 * 24;
        job_scene3d_free(&scene);
    }
    cr_expect_lt(n_ambiguous, n_rays / 20, "too much is left out: %d of %d", n_ambiguous, n_rays);
    cr_expect_gt(n_far, 20, "nothing grew: %d", n_far);
}
