// 3D scenes that are made, by name (see scene3d.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Read next: scene3d_sphereflake.c,
// scene3d_random.c, scene3d_lattice.c and scene3d_edge_cases.c for the generators.
#include "scene3d.h"

#include "complain.h"
#include "scene3d_generate.h"
#include "scene_arguments.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_FLAKE_SIZE 4
#define DEFAULT_SPHERES 1000
#define DEFAULT_SEED 1
#define DEFAULT_LATTICE 10
#define DEFAULT_ANGLE 45  // degrees

// ---- Making and releasing -----------------------------------------------------------------------

static void *array_create(int n_entries, size_t entry_size)
{
    return n_entries == 0 ? NULL : calloc((size_t)n_entries, entry_size);
}

int scene3d_create(int n_spheres, int n_materials, int n_lights, Vec3 from, Scene3D *scene)
{
    scene->spheres = array_create(n_spheres, sizeof *scene->spheres);
    scene->material_ids = array_create(n_spheres, sizeof *scene->material_ids);
    scene->materials = array_create(n_materials, sizeof *scene->materials);
    scene->lights = array_create(n_lights, sizeof *scene->lights);
    if ((n_spheres > 0 && (scene->spheres == NULL || scene->material_ids == NULL)) ||
        (n_materials > 0 && scene->materials == NULL) || (n_lights > 0 && scene->lights == NULL)) {
        scene3d_free(scene);
        return scene_report_memory();
    }
    scene->n_spheres = n_spheres;
    scene->n_materials = n_materials;
    scene->n_lights = n_lights;
    for (int i = 0; i < n_spheres; i++) {
        scene->material_ids[i] = (u32)(i % n_materials);
    }
    scene->background = (Vec3){0, 0, 0};
    scene->view = (View){.from = from, .at = {0, 0, 0}, .up = {0, 0, 1}, .angle = DEFAULT_ANGLE};
    return 0;
}

void scene3d_free(Scene3D *scene)
{
    free(scene->spheres);
    free(scene->material_ids);
    free(scene->materials);
    free(scene->lights);
    *scene = (Scene3D){0};
}

Vec3 scene3d_light_color(int n_lights)
{
    f32 brightness = (f32)(1 / sqrt(n_lights));
    return (Vec3){brightness, brightness, brightness};
}

// What a scene without a light gets: one at the eye, so that all that is seen is lit.
static int light_at_eye(Scene3D *scene)
{
    scene->lights = calloc(1, sizeof *scene->lights);
    if (scene->lights == NULL) {
        return scene_report_memory();
    }
    scene->lights[0] = (Light){scene->view.from, scene3d_light_color(1)};
    scene->n_lights = 1;
    return 0;
}

// ---- Generators ---------------------------------------------------------------------------------

// "random" or "random:...".
static int random_open(const char *name, Scene3D *scene)
{
    int64_t n_spheres = DEFAULT_SPHERES;
    int64_t seed = DEFAULT_SEED;
    float min_radius = 0;  // 0 until the user gives one
    float max_radius = 0;
    const SceneArgument takes[] = {
        {"n=", "n=N, a whole number from 0 to 10000000",
         .whole = {&n_spheres, 0, SCENE3D_MAX_SPHERES}},
        {"seed=", "seed=S, a whole number of at least 0", .whole = {&seed, 0, INT64_MAX}},
        {"min=", "min=R, a radius from 0.000001 to 1000",
         .real = {&min_radius, SCENE3D_MIN_RADIUS, SCENE3D_MAX_RADIUS}},
        {"max=", "max=R, a radius from 0.000001 to 1000",
         .real = {&max_radius, SCENE3D_MIN_RADIUS, SCENE3D_MAX_RADIUS}},
        {.name = NULL},
    };
    if (scene_arguments_read(name, takes, "n=N, seed=S, min=R or max=R") != 0) {
        return -1;
    }
    float default_min, default_max;
    scene3d_default_radii((int)n_spheres, &default_min, &default_max);
    min_radius = min_radius > 0 ? min_radius : default_min;
    max_radius = max_radius > 0 ? max_radius : default_max;
    if (scene_arguments_check_radii(name, min_radius, max_radius) != 0) {
        return -1;
    }
    return scene3d_random((int)n_spheres, (uint64_t)seed, min_radius, max_radius, scene);
}

static int sphereflake_open(const char *name, Scene3D *scene)
{
    int64_t size = DEFAULT_FLAKE_SIZE;
    const SceneArgument takes[] = {
        {"size=", "size=N, a whole number from 0 to 7",
         .whole = {&size, 0, SCENE3D_MAX_FLAKE_SIZE}},
        {.name = NULL},
    };
    if (scene_arguments_read(name, takes, "size=N") != 0) {
        return -1;
    }
    return scene3d_sphereflake((int)size, scene);
}

static int lattice_open(const char *name, Scene3D *scene)
{
    int64_t n_per_side = DEFAULT_LATTICE;
    const SceneArgument takes[] = {
        {"n=", "n=N, a whole number from 1 to 215", .whole = {&n_per_side, 1, SCENE3D_MAX_LATTICE}},
        {.name = NULL},
    };
    if (scene_arguments_read(name, takes, "n=N") != 0) {
        return -1;
    }
    return scene3d_lattice((int)n_per_side, scene);
}

_Static_assert(SCENE3D_MAX_SPHERES == 10000000 && SCENE3D_MAX_FLAKE_SIZE == 7 &&
                   SCENE3D_MAX_LATTICE == 215,
               "the messages above name these limits");

// ---- By name ------------------------------------------------------------------------------------

static const Scene3DEdgeCase *edge_case_find(const char *name)
{
    for (const Scene3DEdgeCase *edge_case = SCENE3D_EDGE_CASES; edge_case->name != NULL;
         edge_case++) {
        if (strcmp(edge_case->name, name) == 0) {
            return edge_case;
        }
    }
    return NULL;
}

static int generate(const char *name, Scene3D *scene)
{
    const Scene3DEdgeCase *edge_case = edge_case_find(name);
    if (edge_case != NULL) {
        return scene3d_edge_case_open(edge_case, scene);
    }
    if (scene_is_called(name, "sphereflake")) {
        return sphereflake_open(name, scene);
    }
    if (scene_is_called(name, "random")) {
        return random_open(name, scene);
    }
    if (scene_is_called(name, "lattice")) {
        return lattice_open(name, scene);
    }
    return scene_report_unknown(name, SCENE3D_NAMES, scene3d_edge_case);
}

// Has the view an angle at which its pixels have rays of their own? It depends on the picture's
// size, which is not always the file's. Returns 0, or -1 after one message.
static int angle_check(const char *name, const Scene3D *scene)
{
    const double smallest = scene3d_smallest_angle(&scene->view, scene->height);
    if ((double)scene->view.angle >= smallest) {
        return 0;
    }
    complain(
        "--scene %s: found a view's angle of %g degrees, expected at least %.3g for %d rows of "
        "pixels: below, float makes the rays of neighbouring pixels the same",
        name, (double)scene->view.angle, smallest, scene->height);
    return -1;
}

int scene3d_settle(const char *name, int width, int height, int made, Scene3D *scene)
{
    int result = made;
    if (result == 0 && scene->n_lights == 0) {
        result = light_at_eye(scene);
    }
    if (result == 0 && width > 0 && height > 0) {
        scene->width = width;
        scene->height = height;
    }
    if (result != 0 || angle_check(name, scene) != 0) {
        scene3d_free(scene);
        return -1;
    }
    return 0;
}

int scene3d_generate(const char *name, int width, int height, Scene3D *scene)
{
    *scene = (Scene3D){.width = SCENE3D_DEFAULT_SIZE, .height = SCENE3D_DEFAULT_SIZE};
    return scene3d_settle(name, width, height, generate(name, scene), scene);
}

const char *scene3d_edge_case(int index)
{
    return SCENE3D_EDGE_CASES[index].name;
}
