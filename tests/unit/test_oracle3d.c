// judge/oracle3d: right where right can be worked out by hand, and honest about what float cannot
// decide.
#include "camera_from_view.h"
#include "oracle3d.h"
#include "random.h"
#include "surroundings.h"

#include <math.h>

TestSuite(oracle3d);

static const OracleRules3D RIGHT = {0};

static void expect_near(OracleVector found, double x, double y, double z)
{
    cr_expect(fabs(found.x - x) < 1e-12 && fabs(found.y - y) < 1e-12 && fabs(found.z - z) < 1e-12,
              "found (%g, %g, %g), expected (%g, %g, %g)", found.x, found.y, found.z, x, y, z);
}

// ---- By hand ------------------------------------------------------------------------------------

Test(oracle3d, axes_of_simple_views)
{
    OracleVector axes[3];
    const View along_y = {.from = {1, 2, 3}, .at = {1, 7, 3}, .up = {0, 0, 9}};
    oracle3d_axes(&along_y, axes);
    expect_near(axes[0], 1, 0, 0);
    expect_near(axes[1], 0, 0, 1);
    expect_near(axes[2], 0, 1, 0);
    // What `up` has along the view does not count.
    const View tilted = {.from = {0}, .at = {0, 0, -2}, .up = {0, 3, -40}};
    oracle3d_axes(&tilted, axes);
    expect_near(axes[0], 1, 0, 0);
    expect_near(axes[1], 0, 1, 0);
    expect_near(axes[2], 0, 0, -1);
}

Test(oracle3d, pixels_stand_on_the_display)
{
    expect_near(oracle3d_display(0, 0, 4, 2, 2, &RIGHT), -0.75, 0.25, 1);
    expect_near(oracle3d_display(3, 1, 4, 2, 2, &RIGHT), 0.75, -0.25, 1);
    expect_near(oracle3d_display(1, 3, 3, 7, 3, &RIGHT), 0, 0, 1);
    expect_near(oracle3d_display(0, 0, 4, 2, 2, &(OracleRules3D){.sample_offset = -0.5}), -1, 0.5,
                1);
    expect_near(oracle3d_display(0, 0, 4, 2, 2, &(OracleRules3D){.fov_is_height = 1}), -1.5, 0.5,
                1);
    expect_near(oracle3d_display(0, 0, 4, 2, 2, &(OracleRules3D){.fov_both_ways = 1}), -0.75, 0.5,
                1);
}

// The t of a ray from the origin along x, from t_min on.
static double t_along_x(Sphere sphere, float t_min, const OracleRules3D *rules)
{
    const OracleRay ray = oracle3d_given_ray((Vec3){0}, (Vec3){1, 0, 0}, t_min);
    const OracleRoot root = oracle3d_root(sphere, &ray, ORACLE_PROJECTION, rules);
    cr_expect(root.t == INFINITY
                  ? !root.is_certain
                  : root.is_possible && root.t_low <= root.t && root.t <= root.t_high,
              "t %g in [%g, %g]", root.t, root.t_low, root.t_high);
    return root.t;
}

Test(oracle3d, a_hit_is_the_nearer_root_beyond_t_min)
{
    static const struct {
        Sphere sphere;
        float t_min;
        double t;
    } cases[] = {{{5, 0, 0, 2}, 0, 3},         {{5, 0, 0, 2}, 4, 7},
                 {{5, 0, 0, 2}, 8, INFINITY},  {{1, 0, 0, 2}, 0, 3},
                 {{-5, 0, 0, 2}, 0, INFINITY}, {{5, 0, 0, -2}, 0, 7},
                 {{1, 0, 0, -2}, 0, 3},        {{5, 3, 0, 5}, 0, 1},
                 {{5, 3, 4, 4}, 0, INFINITY},  {{5, 3, 0, 2.5f}, 0, INFINITY}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double t = t_along_x(cases[i].sphere, cases[i].t_min, &RIGHT);
        cr_expect(t == cases[i].t || fabs(t - cases[i].t) < 1e-12, "case %zu: %g", i, t);
    }
}

Test(oracle3d, roots_can_be_wrong_on_purpose)
{
    const Sphere before = {5, 0, 0, 2}, around = {1, 0, 0, 2}, behind = {-5, 0, 0, 2},
                 inverted = {5, 0, 0, -2};
    cr_expect_eq(t_along_x(before, 0, &(OracleRules3D){.farther_root = 1}), 7);
    cr_expect_eq(t_along_x(behind, 0, &(OracleRules3D){.any_distance = 1}), -7);
    cr_expect_eq(t_along_x(around, 0, &(OracleRules3D){.inside_is_miss = 1}), INFINITY);
    cr_expect_eq(t_along_x(before, 0, &(OracleRules3D){.inside_is_miss = 1}), 3);
    cr_expect_eq(t_along_x(inverted, 0, &(OracleRules3D){.radius_sign_ignored = 1}), 3);
    cr_expect_eq(t_along_x(inverted, 0, &(OracleRules3D){.negative_radius_missed = 1}), INFINITY);
}

static u32 winner(const Sphere *spheres, u32 n_spheres, const OracleRules3D *rules)
{
    const OracleRay ray = oracle3d_given_ray((Vec3){0}, (Vec3){1, 0, 0}, 0);
    const OracleHit hit = oracle3d_nearest(spheres, n_spheres, &ray, rules);
    cr_expect_eq(hit.is_ambiguous, 0);
    return hit.sphere;
}

Test(oracle3d, the_nearest_wins_and_the_first_of_equals)
{
    // The last one stands behind the end.
    static const Sphere spheres[] = {{9, 0, 0, 1}, {5, 0, 0, 1},  {5, 0, 0, 1}, {12, 0, 0, 1},
                                     {7, 0, 0, 1}, {-2, 0, 0, 1}, {2, 0, 0, 1}};
    cr_expect_eq(winner(spheres, 6, &RIGHT), 1);
    cr_expect_eq(winner(spheres, 6, &(OracleRules3D){.later_wins_ties = 1}), 2);
    cr_expect_eq(winner(spheres, 6, &(OracleRules3D){.first_wins = 1}), 0);
    cr_expect_eq(winner(spheres, 6, &(OracleRules3D){.last_wins = 1}), 4);
    cr_expect_eq(winner(spheres, 6, &(OracleRules3D){.farthest_wins = 1}), 3);
    cr_expect_eq(winner(spheres, 6, &(OracleRules3D){.one_sphere_more = 1}), 6);
    cr_expect_eq(winner(spheres + 1, 1, &(OracleRules3D){.skip_first = 1}), ORACLE_NO_SPHERE);
    cr_expect_eq(winner(spheres + 1, 1, &(OracleRules3D){.skip_last = 1}), ORACLE_NO_SPHERE);
    cr_expect_eq(winner(spheres, 0, &RIGHT), ORACLE_NO_SPHERE);
    cr_expect_eq(winner(spheres, 0, &(OracleRules3D){.skip_first = 1, .skip_last = 1}),
                 ORACLE_NO_SPHERE);
}

Test(oracle3d, lambert_by_hand)
{
    const OracleNear point = {{0, 0, 0}, 0}, normal = {{0, 0, 1}, 0};
    const Material material = {.color = {1, 0.5f, 0.25f}, .kd = 0.5f};
    // Straight above, at 60 degrees, and behind; the last stands behind the end.
    const Light lights[] = {{{0, 0, 7}, {1, 1, 1}},
                            {{0, 1.7320508f, 1}, {0, 1, 0}},
                            {{0, 0, -3}, {1, 1, 1}},
                            {{0, 0, 1}, {0, 0, 4}}};
    const OracleNear color = oracle3d_shade(point, normal, &material, lights, 3, &RIGHT);
    cr_expect(fabs(color.value.x - 0.5) < 1e-7 && fabs(color.value.y - 0.375) < 1e-7 &&
              fabs(color.value.z - 0.125) < 1e-7);
    cr_expect(color.error > 0x1p-24 && color.error < 1e-5);
    cr_expect_eq(
        oracle3d_shade(point, normal, &material, lights, 3, &(OracleRules3D){.ignore_kd = 1})
            .value.x,
        1);
    cr_expect_eq(oracle3d_shade(point, normal, &material, lights, 3,
                                &(OracleRules3D){.cosine_not_clamped = 1})
                     .value.x,
                 0);
    cr_expect(fabs(oracle3d_shade(point, normal, &material, lights, 3,
                                  &(OracleRules3D){.one_light_more = 1})
                       .value.z -
                   0.625) < 1e-7);
    cr_expect_eq(oracle3d_shade(point, normal, &material, lights, 0, &RIGHT).value.x, 0);
}

Test(oracle3d, normals_turn_towards_the_eye)
{
    const Sphere sphere = {1, 2, 3, 2};
    const OracleNear point = {{3, 2, 3}, 0}, inwards = {{-1, 0, 0}, 0}, outwards = {{1, 0, 0}, 0};
    expect_near(oracle3d_normal(sphere, point, inwards, &RIGHT).value, 1, 0, 0);
    expect_near(oracle3d_normal(sphere, point, outwards, &RIGHT).value, -1, 0, 0);
    expect_near(
        oracle3d_normal(sphere, point, outwards, &(OracleRules3D){.normal_not_turned = 1}).value, 1,
        0, 0);
    expect_near(
        oracle3d_normal(sphere, point, inwards, &(OracleRules3D){.normal_not_normalised = 1}).value,
        2, 0, 0);
    const OracleNear along = {{0, 1, 0}, 0};
    cr_expect(isinf(oracle3d_normal(sphere, point, along, &RIGHT).error), "either side is right");
}

// ---- What float cannot decide -------------------------------------------------------------------

Test(oracle3d, grazing_and_equally_far_are_ambiguous)
{
    const OracleRay ray = oracle3d_given_ray((Vec3){0}, (Vec3){1, 0, 0}, 0);
    const Sphere grazing = {5, 2, 0, 2}, clear = {5, 1.999f, 0, 2}, missed = {5, 2.001f, 0, 2};
    cr_expect(oracle3d_nearest(&grazing, 1, &ray, &RIGHT).is_ambiguous);
    cr_expect_not(oracle3d_nearest(&clear, 1, &ray, &RIGHT).is_ambiguous);
    cr_expect_not(oracle3d_nearest(&missed, 1, &ray, &RIGHT).is_ambiguous);
    // Two different spheres hit at the same distance; a grazing one before and behind another.
    const Sphere equal[] = {{5, 0, 0, 2}, {6, 0, 0, 3}};
    const Sphere hidden[] = {{5, 0, 0, 2}, {9, 2, 0, 2}};
    const Sphere hiding[] = {{9, 0, 0, 2}, {5, 2, 0, 2}};
    cr_expect(oracle3d_nearest(equal, 2, &ray, &RIGHT).is_ambiguous);
    cr_expect_not(oracle3d_nearest(hidden, 2, &ray, &RIGHT).is_ambiguous);
    cr_expect(oracle3d_nearest(hiding, 2, &ray, &RIGHT).is_ambiguous);
    // The eye on the sphere: is the near root beyond 0?
    const Sphere touched = {2, 0, 0, 2};
    cr_expect(oracle3d_nearest(&touched, 1, &ray, &RIGHT).t_tolerance > 3.9);
}

// The solution's arithmetic in float.
static float root_in_float(Sphere sphere, Vec3 origin, Vec3 direction, int is_textbook)
{
    const Vec3 c = vec3_minus((Vec3){sphere.x, sphere.y, sphere.z}, origin);
    const float b = vec3_dot(c, direction);
    const Vec3 l = vec3_minus(c, vec3_scaled(direction, b));
    const float r2 = sphere.radius * sphere.radius;
    const float disc = is_textbook ? b * b - (vec3_dot(c, c) - r2) : r2 - vec3_dot(l, l);
    if (disc < 0) {
        return INFINITY;
    }
    const float t_near = b - sqrtf(disc), t_far = b + sqrtf(disc);
    return t_near > 0 && sphere.radius > 0 ? t_near : t_far > 0 ? t_far : INFINITY;
}

static float anywhere(Random *random, double lowest, double highest)
{
    return (float)(lowest + (highest - lowest) * (double)(random_bits(random) >> 11) * 0x1p-53);
}

static Vec3 some_vector(Random *random, double reach)
{
    return (Vec3){anywhere(random, -reach, reach), anywhere(random, -reach, reach),
                  anywhere(random, -reach, reach)};
}

static int is_within(const OracleRoot *root, float t)
{
    return t == INFINITY ? !root->is_certain
                         : root->is_possible && t >= root->t_low && t <= root->t_high;
}

Test(oracle3d, float_stays_within_the_bounds)
{
    Random random = {3};
    int n_hits = 0, n_open = 0, n_lost = 0;
    for (int i = 0; i < 300000; i++) {
        const Vec3 origin = some_vector(&random, 5);
        const Vec3 direction = vec3_normalized(some_vector(&random, 1));
        const float distance = anywhere(&random, 0.01, i % 2 ? 10 : 500);
        const float radius = distance * anywhere(&random, 0.0001, i % 4 ? 0.01 : 2);
        // Most rays pass near the sphere's edge.
        const Vec3 aside = vec3_normalized(vec3_cross(direction, some_vector(&random, 1)));
        const float miss = radius * (i % 3 ? anywhere(&random, 0, 1.2) : 1);
        const Sphere sphere = {origin.x + distance * direction.x + miss * aside.x,
                               origin.y + distance * direction.y + miss * aside.y,
                               origin.z + distance * direction.z + miss * aside.z,
                               i % 5 ? radius : -radius};
        const OracleRay ray = oracle3d_given_ray(origin, direction, 0);
        const OracleRoot projection = oracle3d_root(sphere, &ray, ORACLE_PROJECTION, &RIGHT);
        const OracleRoot textbook = oracle3d_root(sphere, &ray, ORACLE_TEXTBOOK, &RIGHT);
        const float t = root_in_float(sphere, origin, direction, 0);
        const float t_textbook = root_in_float(sphere, origin, direction, 1);
        cr_assert(is_within(&projection, t), "%d: %.9g not in [%.12g, %.12g]", i, (double)t,
                  projection.t_low, projection.t_high);
        cr_assert(is_within(&textbook, t_textbook), "%d: %.9g not in [%.12g, %.12g]", i,
                  (double)t_textbook, textbook.t_low, textbook.t_high);
        n_hits += projection.is_certain;
        n_open += projection.is_possible && !projection.is_certain;
        n_lost += !is_within(&projection, t_textbook);
    }
    // Else nothing was tried, or too much is let pass.
    cr_expect(n_hits > 100000 && n_open > 1000 && n_open < 120000, "%d, %d", n_hits, n_open);
    cr_expect_gt(n_lost, 10000, "the textbook's form is not told from the other: %d", n_lost);
}

Test(oracle3d, few_rays_of_a_picture_are_ambiguous)
{
    enum { WIDTH = 80, HEIGHT = 60 };
    static const char *const names[] = {"random:n=80", "sphereflake:size=2", "inside",
                                        "behind",      "large-small",        "coincident"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        Scene3D scene;
        Image image;
        cr_assert_eq(scene3d_open(names[i], WIDTH, HEIGHT, &scene), 0);
        cr_assert_eq(image_create(WIDTH, HEIGHT, &image), 0);
        const Camera camera = camera_from_view(scene.view, WIDTH, HEIGHT);
        static float tolerances[HEIGHT * WIDTH];
        static OracleHit hits[HEIGHT * WIDTH];
        oracle3d_draw(&scene, &camera, &RIGHT, &image, tolerances, hits);
        int n_ambiguous = 0, n_rough = 0, n_hits = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            n_ambiguous += hits[pixel].is_ambiguous;
            n_rough += tolerances[pixel] > 0x1p-8f;
            n_hits += hits[pixel].sphere != ORACLE_NO_SPHERE;
        }
        cr_expect(n_hits > 100 && n_ambiguous < 40 && n_rough < WIDTH * HEIGHT / 50,
                  "%s: %d hits, %d ambiguous, %d with a tolerance beyond 1/256", names[i], n_hits,
                  n_ambiguous, n_rough);
        image_free(&image);
        scene3d_free(&scene);
    }
}
