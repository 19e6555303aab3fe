// common/scene3d: names, the view, the generators and the edge cases.
#include "scene3d.h"
#include "surroundings.h"

#include <math.h>

TestSuite(scene3d, .init = folder_enter, .fini = folder_leave);

static Scene3D scene_open(const char *name)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open(name, 0, 0, &scene), 0, "%s", name);
    return scene;
}

// In double, where differences of these numbers are exact.
static double distance_between(const Sphere *a, const Sphere *b)
{
    double dx = (double)a->x - b->x;
    double dy = (double)a->y - b->y;
    double dz = (double)a->z - b->z;
    return sqrt(dx * dx + dy * dy + dz * dz);
}

static double distance_from_eye(const Scene3D *scene, int i)
{
    Sphere eye = {scene->view.from.x, scene->view.from.y, scene->view.from.z, 0};
    return distance_between(&scene->spheres[i], &eye);
}

static double size_of(const Scene3D *scene, int i)
{
    return fabs((double)scene->spheres[i].radius);
}

// ---- Every generated scene ----------------------------------------------------------------------

static int is_share(float value)
{
    return value >= 0 && value <= 1;
}

static void expect_well_formed(const Scene3D *scene, const char *name)
{
    for (int i = 0; i < scene->n_spheres; i++) {
        const Sphere *sphere = &scene->spheres[i];
        cr_assert(isfinite(sphere->x) && isfinite(sphere->y) && isfinite(sphere->z) &&
                      isfinite(sphere->radius) && sphere->radius != 0,
                  "%s: sphere %d", name, i);
        cr_assert_lt(scene->material_ids[i], (u32)scene->n_materials, "%s: sphere %d", name, i);
    }
    for (int i = 0; i < scene->n_materials; i++) {
        const Material *material = &scene->materials[i];
        cr_assert(is_share(material->color.x) && is_share(material->color.y) &&
                      is_share(material->color.z) && is_share(material->kd) &&
                      is_share(material->ks) && material->kd > 0,
                  "%s: material %d", name, i);
    }
    cr_expect_gt(scene->n_lights, 0, "%s", name);
    for (int i = 0; i < scene->n_lights; i++) {
        float brightness = (float)(1 / sqrt(scene->n_lights));
        cr_expect_eq(scene->lights[i].color.x, brightness, "%s: light %d", name, i);
    }
    cr_expect_null(scene3d_view_fault(&scene->view), "%s", name);
    cr_expect(scene->view.angle > 0 && scene->view.angle < 180, "%s", name);
    cr_expect_eq(scene->spheres == NULL, scene->n_spheres == 0, "%s", name);
}

// FNV-1a over spheres, materials and what spheres are made of.
static uint64_t bytes_add(uint64_t sum, const void *bytes, size_t n_bytes)
{
    for (size_t i = 0; i < n_bytes; i++) {
        sum = (sum ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3u;
    }
    return sum;
}

static uint64_t scene_checksum(const Scene3D *scene)
{
    const size_t n_spheres = (size_t)scene->n_spheres;
    uint64_t sum = 0xcbf29ce484222325u;
    sum = bytes_add(sum, scene->spheres, n_spheres * sizeof *scene->spheres);
    sum = bytes_add(sum, scene->material_ids, n_spheres * sizeof *scene->material_ids);
    sum = bytes_add(sum, scene->materials, (size_t)scene->n_materials * sizeof *scene->materials);
    sum = bytes_add(sum, scene->lights, (size_t)scene->n_lights * sizeof *scene->lights);
    return bytes_add(sum, &scene->view, sizeof scene->view);
}

// The numbers are pinned: a change of a generator would change every picture of its scenes,
// reference images and bench figures among them, and must not slip in unseen.
static const struct {
    const char *name;
    int n_spheres;
    uint64_t checksum;
} GENERATED[] = {
    {"sphereflake:size=3", 820, 0xe6826aa33c4760b6u},
    {"random", 1000, 0xb30c7f1c8cf2091cu},
    {"random:n=100,seed=3", 100, 0xde902f3573096429u},
    {"lattice:n=3", 27, 0x141fca282d5b1618u},
    {"inside", 49, 0x5bb56fe526576247u},
    {"planes", 106, 0xc22806ef8eccb5dfu},
    {"one-cell", 251, 0x2bb7c4e989c9d2a1u},
    {"one", 1, 0xa0848c3c3c17fe66u},
    {"none", 0, 0x7432fa78cb08835fu},
    {"coincident", 192, 0x887a9e9a2be34a52u},
    {"large-small", 259, 0x7f4f203dbe39bf73u},
    {"behind", 61, 0xe663060a24efbcb7u},
};

Test(scene3d, generated_scenes_are_well_formed_and_the_same_everywhere)
{
    for (size_t i = 0; i < sizeof GENERATED / sizeof GENERATED[0]; i++) {
        const char *name = GENERATED[i].name;
        Scene3D scene = scene_open(name);
        Scene3D again = scene_open(name);
        expect_well_formed(&scene, name);
        cr_expect_eq(scene.n_spheres, GENERATED[i].n_spheres, "%s: %d", name, scene.n_spheres);
        cr_expect_eq(scene_checksum(&scene), GENERATED[i].checksum, "%s: 0x%016llx", name,
                     (unsigned long long)scene_checksum(&scene));
        cr_expect_eq(scene_checksum(&again), scene_checksum(&scene), "%s", name);
        scene3d_free(&scene);
        scene3d_free(&again);
    }
}

Test(scene3d, freed_twice_is_fine)
{
    Scene3D scene = scene_open("one");
    scene3d_free(&scene);
    cr_expect_null(scene.spheres);
    cr_expect_eq(scene.n_lights, 0);
    scene3d_free(&scene);
}

// ---- The picture's size -------------------------------------------------------------------------

#define NFF_WITHOUT_LIGHT                                                                          \
    "v\nfrom 3 1 2\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 40 30\n"                    \
    "b 0 0 0\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\n"

static void expect_size(const char *name, int width, int height, int real_width, int real_height)
{
    Scene3D scene;
    cr_assert_eq(scene3d_open(name, width, height, &scene), 0, "%s", name);
    cr_expect(scene.width == real_width && scene.height == real_height, "%s: %dx%d", name,
              scene.width, scene.height);
    scene3d_free(&scene);
}

Test(scene3d, the_users_size_goes_before_the_scenes)
{
    file_write("scene.nff", NFF_WITHOUT_LIGHT, strlen(NFF_WITHOUT_LIGHT));
    expect_size("random:n=1", 0, 0, SCENE3D_DEFAULT_SIZE, SCENE3D_DEFAULT_SIZE);
    expect_size("random:n=1", 20, 10, 20, 10);
    expect_size("planes", 0, 0, 65, 49);
    expect_size("planes", 20, 10, 20, 10);
    expect_size("scene.nff", 0, 0, 40, 30);
    expect_size("scene.nff", 20, 10, 20, 10);
}

Test(scene3d, a_scene_without_light_gets_one_at_the_eye)
{
    file_write("scene.nff", NFF_WITHOUT_LIGHT, strlen(NFF_WITHOUT_LIGHT));
    Scene3D scene = scene_open("scene.nff");
    cr_assert_eq(scene.n_lights, 1);
    const Light *light = &scene.lights[0];
    cr_expect(light->position.x == 3 && light->position.y == 1 && light->position.z == 2);
    cr_expect(light->color.x == 1 && light->color.y == 1 && light->color.z == 1);
    scene3d_free(&scene);
}

// ---- The view -----------------------------------------------------------------------------------

Test(scene3d, fov_follows_the_rows)
{
    View view = {.angle = 90};
    cr_expect_float_eq(scene3d_fov(&view, 1, 2), 2.0f, 1e-6f);  // from -1 to 1 in one step
    cr_expect_float_eq(scene3d_fov(&view, 3, 2), 6.0f, 1e-6f);
    cr_expect_float_eq(scene3d_fov(&view, 640, 481), 640 / 240.0f, 1e-6f);
    cr_expect_float_eq(scene3d_fov(&view, 5, 1), 10.0f, 1e-5f, "one row is as two");
    view.angle = 45;
    cr_expect_float_eq(scene3d_fov(&view, 512, 513), 2 * (sqrtf(2) - 1), 1e-6f);
}

#define OUT_OF_RANGE "the view's direction or up is too short or too long (1e-32 to 1e32)"

// Exact values stand for themselves; 1e30 and 1e-30 overflow and vanish when squared in float.
static const struct {
    Vec3 from, at, up;
    const char *fault;
} VIEWS[] = {
    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, NULL},
    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e-30f}, NULL},
    {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e30f}, NULL},
    {{0, 0, 0}, {1e30f, 0, 0}, {0, 0, 1}, NULL},
    {{0, 0, 0}, {1e-30f, 0, 0}, {0, 0, 1}, NULL},
    {{0, 0, 0}, {1e-30f, 0, 0}, {0, 1e-30f, 0}, NULL},
    {{3e38f, 0, 0}, {-3e38f, 0, 0}, {0, 1, 0}, OUT_OF_RANGE},
    {{0, 0, 0}, {1e-45f, 0, 0}, {0, 0, 1}, OUT_OF_RANGE},
    {{1e-30f, 0, 0}, {0, 0, 0}, {0, 3e38f, 0}, OUT_OF_RANGE},
    {{0, 0, 0}, {1, 0, 0}, {0, 1e-33f, 0}, OUT_OF_RANGE},
    {{1, 2, 3}, {4, 5, 6}, {1, 1, 1.001f}, NULL},
    {{1, 2, 3}, {1, 2, 3}, {0, 0, 1}, "the view's direction is zero (from is at)"},
    {{1e30f, 0, 0}, {1e30f, 0, 0}, {0, 0, 1}, "the view's direction is zero (from is at)"},
    {{1, 2, 3}, {1, 2, 3}, {0, 0, 0}, "the view's direction is zero (from is at)"},
    {{1, 2, 3}, {0, 0, 0}, {0, 0, 0}, "up is zero"},
    {{1, 2, 3}, {0, 0, 0}, {0, -0.0f, 0}, "up is zero"},
    {{0, 0, 5}, {0, 0, 0}, {0, 0, 1}, "up is parallel to the view"},
    {{0, 0, 0}, {0, 0, 5}, {0, 0, 1}, "up is parallel to the view"},
    {{1, 2, 3}, {4, 5, 6}, {-2, -2, -2}, "up is parallel to the view"},
    {{1, 2, 3}, {4, 5, 6}, {1, 1, 1.0001f}, "up is parallel to the view"},
    {{0, 0, 0}, {0, 1e30f, 0}, {0, 1e-30f, 0}, "up is parallel to the view"},
    {{0, 0, 0}, {1e31f, 1e31f, 0}, {1e31f, 1e31f, 0}, "up is parallel to the view"},
    {{0, 0, 0}, {0, 1e-31f, 0}, {0, 1e-31f, 0}, "up is parallel to the view"},
};

Test(scene3d, views_that_do_not_work_are_told)
{
    for (size_t i = 0; i < sizeof VIEWS / sizeof VIEWS[0]; i++) {
        View view = {VIEWS[i].from, VIEWS[i].at, VIEWS[i].up, 45, 0};
        const char *fault = scene3d_view_fault(&view);
        if (VIEWS[i].fault == NULL) {
            cr_expect_null(fault, "view %zu: %s", i, fault);
        } else {
            cr_assert_not_null(fault, "view %zu", i);
            cr_expect_str_eq(fault, VIEWS[i].fault, "view %zu: %s", i, fault);
        }
    }
}

// The camera's axes in double, and the ray through pixel (x, y), not of unit length.
typedef struct Axes {
    double forward[3], right[3], up[3];
} Axes;

static void cross_normalized(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = a[j] * b[k] - a[k] * b[j];
    }
    double length = sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    for (int i = 0; i < 3; i++) {
        result[i] /= length;
    }
}

static Axes axes_of(const View *view)
{
    Axes axes = {.forward = {(double)view->at.x - view->from.x, (double)view->at.y - view->from.y,
                             (double)view->at.z - view->from.z}};
    double up[3] = {view->up.x, view->up.y, view->up.z};
    double length = sqrt(axes.forward[0] * axes.forward[0] + axes.forward[1] * axes.forward[1] +
                         axes.forward[2] * axes.forward[2]);
    for (int i = 0; i < 3; i++) {
        axes.forward[i] /= length;
    }
    cross_normalized(axes.forward, up, axes.right);
    cross_normalized(axes.right, axes.forward, axes.up);
    return axes;
}

static void ray_towards(const Axes *axes, double spacing, double pixels_right, double pixels_up,
                        double ray[3])
{
    for (int i = 0; i < 3; i++) {
        ray[i] =
            axes->forward[i] + spacing * (pixels_right * axes->right[i] + pixels_up * axes->up[i]);
    }
}

// Do two rays, half a pixel to this side of the view's axis and to that, differ in float? So the
// kernels compute them.
static int are_rays_distinct(const Axes *axes, const double sideways[3], double spacing)
{
    int are_distinct = 0;
    for (int i = 0; i < 3; i++) {
        const float forward = (float)axes->forward[i], side = (float)sideways[i];
        const volatile float here = forward + 0.5f * (float)spacing * side;
        const volatile float there = forward - 0.5f * (float)spacing * side;
        are_distinct |= here != there;
    }
    return are_distinct;
}

// At the smallest angle, and the rounding of it, neighbours differ; at less than half of it the
// larger half of a number's spacing is not reached, and they do not.
Test(scene3d, the_smallest_angle_keeps_neighbouring_rays_apart)
{
    static const View OBLIQUE[] = {
        {.from = {2.1f, 1.3f, 1.7f}, .up = {0, 0, 1}},
        {.from = {-3, 7, 0.3f}, .up = {0, 1, 0}},
        {.from = {100, 101, 102}, .up = {1, 2, 0}},
    };
    for (size_t i = 0; i < sizeof OBLIQUE / sizeof OBLIQUE[0]; i++) {
        const Axes axes = axes_of(&OBLIQUE[i]);
        for (int height = 2; height <= 4096; height *= 8) {
            const double angle = scene3d_smallest_angle(&OBLIQUE[i], height);
            const double spacing = 2 * tan(angle / 2 * M_PI / 180) / (height - 1);
            cr_expect(are_rays_distinct(&axes, axes.right, 1.01 * spacing), "view %zu", i);
            cr_expect(are_rays_distinct(&axes, axes.up, 1.01 * spacing), "view %zu", i);
            cr_expect(!are_rays_distinct(&axes, axes.right, 0.49 * spacing) ||
                          !are_rays_distinct(&axes, axes.up, 0.49 * spacing),
                      "view %zu: %g is not the smallest angle", i, angle);
        }
    }
    // Along an axis float is as fine as it gets: nothing is refused that could be drawn.
    const View along = {.from = {3000, 0, 0}, .up = {0, 0, 1}};
    cr_expect_lt(scene3d_smallest_angle(&along, 1000), 1e-30);
    cr_expect_gt(scene3d_smallest_angle(&along, 1000), 1.4e-45);
}

// ---- Sphereflake --------------------------------------------------------------------------------

Test(scene3d, sphereflake_has_a_ball_more_for_each_power_of_nine)
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

Test(scene3d, sphereflake_balls_touch_their_parents_and_stay_within_1)
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
Test(scene3d, sphereflake_stands_as_the_original)
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
Test(scene3d, sphereflake_is_seen_from_where_every_ray_would_hit_its_floor)
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

static int is_multiple(float value, float step)
{
    return value / step == floorf(value / step);
}

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

Test(scene3d, random_takes_its_arguments_in_any_order)
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

Test(scene3d, default_radii_are_shares_of_the_spacing)
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

Test(scene3d, a_million_random_spheres)
{
    Scene3D scene = scene_open("random:n=1000000");
    cr_assert_eq(scene.n_spheres, 1000000);
    expect_random(&scene, 0.002f, 0.008f);
    scene3d_free(&scene);
}

// All of the cube fits into the picture, whichever way it is turned.
Test(scene3d, random_and_lattice_are_seen_as_a_whole)
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

Test(scene3d, lattice_spheres_are_equal_and_apart)
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

// ---- Edge cases ---------------------------------------------------------------------------------

Test(scene3d, edge_cases_are_these)
{
    static const char *const NAMES[] = {"inside", "planes",     "one-cell",    "one",
                                        "none",   "coincident", "large-small", "behind"};
    for (int i = 0; i < 8; i++) {
        cr_assert_not_null(scene3d_edge_case(i));
        cr_expect_str_eq(scene3d_edge_case(i), NAMES[i]);
        Scene3D scene = scene_open(NAMES[i]);
        cr_expect_leq(scene.n_spheres, 512);
        scene3d_free(&scene);
    }
    cr_expect_null(scene3d_edge_case(8));
}

Test(scene3d, inside_has_the_eye_in_a_sphere_with_others_in_and_outside)
{
    Scene3D scene = scene_open("inside");
    const Sphere *wall = &scene.spheres[0];
    cr_expect_lt(distance_from_eye(&scene, 0), size_of(&scene, 0));
    int n_in = 0, n_across = 0, n_outside = 0, n_negative = 0;
    for (int i = 1; i < scene.n_spheres; i++) {
        double distance = distance_between(wall, &scene.spheres[i]);
        double size = size_of(&scene, i);
        n_in += distance + size < (double)wall->radius;
        n_outside += distance - size > (double)wall->radius;
        n_across += fabs(distance - (double)wall->radius) < size;
        n_negative += scene.spheres[i].radius < 0;
        cr_expect(distance_from_eye(&scene, i) > size || scene.spheres[i].radius < 0, "%d", i);
    }
    cr_expect(n_in >= 20 && n_across >= 3 && n_outside >= 9 && n_negative == 2, "%d %d %d %d", n_in,
              n_across, n_outside, n_negative);
    scene3d_free(&scene);
}

static const float *centre_of(const Sphere *sphere)
{
    return &sphere->x;  // x, y and z follow each other; see LAYOUT_ASSERT
}

Test(scene3d, planes_has_all_on_halves_and_quarters_of_its_box)
{
    Scene3D scene = scene_open("planes");
    for (int axis = 0; axis < 3; axis++) {
        float lowest = INFINITY, highest = -INFINITY;
        int n_centred = 0, n_below = 0, n_above = 0;  // on planes at -1/2, 0 and 1/2
        for (int i = 0; i < scene.n_spheres; i++) {
            float centre = centre_of(&scene.spheres[i])[axis];
            float radius = scene.spheres[i].radius;
            lowest = fminf(lowest, centre - radius);
            highest = fmaxf(highest, centre + radius);
            n_centred += is_multiple(centre, 0.5f);
            n_below += is_multiple(centre + radius, 0.5f) && fabsf(centre) < 0.6f;
            n_above += is_multiple(centre - radius, 0.5f) && fabsf(centre) < 0.6f;
        }
        cr_expect(lowest == -1 && highest == 1, "axis %d", axis);
        cr_expect(n_centred == 26 && n_below == 12 && n_above == 12, "axis %d: %d %d %d", axis,
                  n_centred, n_below, n_above);
    }
    for (int i = 0; i < scene.n_spheres; i++) {
        cr_expect_gt(distance_from_eye(&scene, i), size_of(&scene, i), "%d is around the eye", i);
        for (int j = 0; j < i; j++) {  // of two that overlap, rounding could choose the nearer
            cr_expect_geq(distance_between(&scene.spheres[i], &scene.spheres[j]),
                          size_of(&scene, i) + size_of(&scene, j), "%d and %d", i, j);
        }
    }
    scene3d_free(&scene);
}

// Rays of the middle column and row stay in planes through the eye, and the eye is on split planes.
Test(scene3d, planes_has_rays_within_its_planes)
{
    Scene3D scene = scene_open("planes");
    const View *view = &scene.view;
    cr_expect(scene.width % 2 == 1 && scene.height % 2 == 1);
    cr_expect(view->from.x == 0.5f && view->from.y == 0 && view->from.z == 0);
    // The camera of lab 04, in float.
    const Vec3 forward = vec3_normalized(vec3_minus(view->at, view->from));
    const Vec3 right = vec3_normalized(vec3_cross(forward, view->up));
    const Vec3 up = vec3_cross(right, forward);
    cr_expect(forward.x == -1 && forward.y == 0 && forward.z == 0);
    cr_expect(right.x == 0 && right.y == 1 && right.z == 0);
    cr_expect(up.x == 0 && up.y == 0 && up.z == 1);
    scene3d_free(&scene);
}

// No ray of the picture grazes a sphere so closely that rounding in float decides about the pixel.
Test(scene3d, planes_leaves_no_pixel_to_rounding)
{
    Scene3D scene = scene_open("planes");
    const Axes axes = axes_of(&scene.view);
    const double spacing =
        (double)scene3d_fov(&scene.view, scene.width, scene.height) / scene.width;
    double closest = INFINITY;
    for (int pixel = 0; pixel < scene.width * scene.height; pixel++) {
        double ray[3];
        ray_towards(&axes, spacing, pixel % scene.width - scene.width / 2,
                    scene.height / 2 - pixel / scene.width, ray);
        double ray2 = ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2];
        for (int i = 0; i < scene.n_spheres; i++) {
            const Sphere *sphere = &scene.spheres[i];
            double to[3] = {(double)sphere->x - scene.view.from.x,
                            (double)sphere->y - scene.view.from.y,
                            (double)sphere->z - scene.view.from.z};
            double along = (to[0] * ray[0] + to[1] * ray[1] + to[2] * ray[2]) / ray2;
            double off2 = 0;  // the squared distance of the centre from the ray
            for (int axis = 0; axis < 3; axis++) {
                off2 += pow(to[axis] - along * ray[axis], 2);
            }
            double radius2 = pow((double)sphere->radius, 2);
            closest = along > 0 ? fmin(closest, fabs(off2 - radius2)) : closest;
        }
    }
    // Squares of distances up to 2 are rounded in float by 2^-22, a few times over.
    cr_expect_gt(closest, 1e-6, "%g", closest);
    scene3d_free(&scene);
}

Test(scene3d, one_cell_holds_all_spheres_but_one)
{
    Scene3D scene = scene_open("one-cell");
    int n_in_cell = 0;
    for (int i = 0; i < scene.n_spheres; i++) {
        const float *centre = centre_of(&scene.spheres[i]);
        float side = 1.0f / 400;  // the box is more than 3 wide
        n_in_cell += fabsf(centre[0] - 1) < side && fabsf(centre[1] - 1) < side &&
                     fabsf(centre[2] - 1) < side;
        cr_expect_gt(distance_from_eye(&scene, i), size_of(&scene, i));
    }
    cr_expect(n_in_cell == scene.n_spheres - 1 && n_in_cell >= 200, "%d", n_in_cell);
    scene3d_free(&scene);
}

// How many spheres share the centre of sphere i, and how many of those its radius; i included.
static void count_equals(const Scene3D *scene, int i, int *n_places, int *n_radii)
{
    *n_places = *n_radii = 0;
    for (int j = 0; j < scene->n_spheres; j++) {
        int same = distance_between(&scene->spheres[i], &scene->spheres[j]) == 0;
        *n_places += same;
        *n_radii += same && scene->spheres[i].radius == scene->spheres[j].radius;
    }
}

Test(scene3d, coincident_has_equal_and_different_radii)
{
    static const int N_WITH_THE_RADIUS[3] = {64, 1, 4};
    Scene3D scene = scene_open("coincident");
    cr_assert_eq(scene.n_spheres, 3 * 64);
    for (int i = 0; i < scene.n_spheres; i++) {
        int n_places, n_radii;
        count_equals(&scene, i, &n_places, &n_radii);
        cr_expect(n_places == 64 && n_radii == N_WITH_THE_RADIUS[i / 64], "%d: %d %d", i, n_places,
                  n_radii);
    }
    // Whose material is seen, must show: of equal spheres each has another than its neighbours.
    cr_expect_neq(scene.material_ids[0], scene.material_ids[1]);
    scene3d_free(&scene);
}

Test(scene3d, large_small_has_radii_far_apart)
{
    Scene3D scene = scene_open("large-small");
    double smallest = INFINITY, largest = 0;
    for (int i = 0; i < scene.n_spheres; i++) {
        smallest = fmin(smallest, size_of(&scene, i));
        largest = fmax(largest, size_of(&scene, i));
        cr_expect_gt(distance_from_eye(&scene, i), size_of(&scene, i));
    }
    cr_expect_geq(largest / smallest, 10000);
    scene3d_free(&scene);
}

Test(scene3d, behind_has_spheres_on_all_sides_of_the_eye)
{
    Scene3D scene = scene_open("behind");
    const Vec3 forward = vec3_minus(scene.view.at, scene.view.from);
    int n_behind = 0, n_before = 0;
    double nearest_behind = INFINITY, nearest_before = INFINITY;
    for (int i = 0; i < scene.n_spheres; i++) {
        const Sphere *sphere = &scene.spheres[i];
        Vec3 to = vec3_minus((Vec3){sphere->x, sphere->y, sphere->z}, scene.view.from);
        double gap = distance_from_eye(&scene, i) - size_of(&scene, i);
        cr_expect_gt(gap, 0, "%d is around the eye", i);
        if (vec3_dot(to, forward) > 0) {
            n_before++;
            nearest_before = fmin(nearest_before, gap);
        } else {
            n_behind++;
            nearest_behind = fmin(nearest_behind, gap);
        }
    }
    cr_expect(n_before >= 10 && n_behind >= 20, "%d %d", n_before, n_behind);
    cr_expect_lt(nearest_behind, nearest_before);
    scene3d_free(&scene);
}

// ---- Names that are none ------------------------------------------------------------------------

static const struct {
    const char *name;
    const char *message;
} BAD[] = {
    {"sphere", "--scene sphere: found no such scene, expected FILE.nff, FILE.pdb, FILE.xyz"},
    {"sphere", "sphereflake[:size=N], random[:n=N,seed=S,min=R,max=R], lattice[:n=N], inside"},
    {"sphere", "large-small, behind"},
    {"", "found no such scene"},
    {".nff", "found no such scene"},
    {"Inside", "found no such scene"},
    {"one:n=1", "found no such scene"},
    {"randomly", "found no such scene"},
    {"scene.csv", "found no such scene"},
    {"missing.nff", "missing.nff: cannot be read: "},
    {"missing.pdb", "missing.pdb: cannot be read: "},
    {"missing.xyz", "missing.xyz: cannot be read: "},
    {"empty.nff", "empty.nff"},
    {"empty.pdb", "empty.pdb"},
    {"empty.xyz", "empty.xyz"},
    {"folder.nff", "folder.nff"},
    {"sphereflake:", "found \"\", expected size=N"},
    {"sphereflake:8", "found \"8\", expected size=N"},
    {"sphereflake:size=8", "found \"size=8\", expected size=N, a whole number from 0 to 7"},
    {"sphereflake:size=-1", "found \"size=-1\""},
    {"sphereflake:n=1", "found \"n=1\""},
    {"lattice:n=0", "found \"n=0\", expected n=N, a whole number from 1 to 215"},
    {"lattice:n=216", "found \"n=216\""},
    {"lattice:size=2", "found \"size=2\", expected n=N"},
    {"random:", "n=N, seed=S, min=R or max=R"},
    {"random:n=", "found \"n=\""},
    {"random:n=-1", "found \"n=-1\""},
    {"random:n=1e3", "found \"n=1e3\""},
    {"random:n=10000001", "expected n=N, a whole number from 0 to 10000000"},
    {"random:n=1,,seed=2", "found \"\""},
    {"random:n=1,", "found \"\""},
    {"random:seed=-1", "found \"seed=-1\", expected seed=S, a whole number of at least 0"},
    {"random:min=0", "found \"min=0\", expected min=R, a radius from 0.000001 to 1000"},
    {"random:min=-1", "found \"min=-1\""},
    {"random:max=1001", "found \"max=1001\", expected max=R, a radius from 0.000001 to 1000"},
    {"random:max=nan", "found \"max=nan\""},
    {"random:max=inf", "found \"max=inf\""},
    {"random:min=5,max=4", "found min=5 above max=4, expected at most that"},
    {"random:n=8,min=0.5", "min=0.5 above max=0.4"},
    {"random:n=5,n=6", "found \"n=6\", expected each argument once"},
    {"random:seed=5,n=6,seed=5", "found \"seed=5\", expected each argument once"},
    {"random:n=5,n=x", "found \"n=x\", expected each argument once"},
};

// As long as a word on a command line may be.
Test(scene3d, however_long_a_bad_name_the_reason_is_told)
{
    static char name[131000];
    static const struct {
        const char *ending, *message;
    } CASES[] = {
        {"", ": found no such scene, expected "},
        {".nff", ": cannot be read: "},
        {":n=1", ": found no such scene, expected "},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        memset(name, 'n', sizeof name - 1);
        strcpy(name + sizeof name - 1 - strlen(CASES[i].ending), CASES[i].ending);
        Scene3D scene;
        capture_begin(2);
        cr_expect_eq(scene3d_open(name, 0, 0, &scene), -1);
        expect_one_message(capture_end(2), CASES[i].message);
    }
    memcpy(name, "random:", strlen("random:"));
    Scene3D scene;
    capture_begin(2);
    cr_expect_eq(scene3d_open(name, 0, 0, &scene), -1);
    expect_one_message(capture_end(2), "\", expected n=N, seed=S, min=R or max=R");
}

Test(scene3d, bad_names_give_one_message)
{
    mkdir("folder.nff", 0777);
    file_write("empty.nff", "", 0);
    file_write("empty.pdb", "", 0);
    file_write("empty.xyz", "", 0);
    for (size_t i = 0; i < sizeof BAD / sizeof BAD[0]; i++) {
        Scene3D scene;
        capture_begin(2);
        int result = scene3d_open(BAD[i].name, 0, 0, &scene);
        expect_one_message(capture_end(2), BAD[i].message);
        cr_expect_eq(result, -1, "%s was opened", BAD[i].name);
        cr_expect(scene.spheres == NULL && scene.lights == NULL && scene.n_spheres == 0);
    }
}
