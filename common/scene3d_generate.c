// 3D scenes that are made, by name (scene3d_generate() of scene3d.h).
//
// Read next: scene3d_sphereflake.c, scene3d_random.c, scene3d_lattice.c, scene3d_uneven.c and
// scene3d_edge_cases.c for the generators.
#include "number.h"
#include "scene3d_edge_cases.h"
#include "scene_arguments.h"

#include <string.h>

#define DEFAULT_FLAKE_SIZE 4
#define DEFAULT_SPHERES 1000
#define DEFAULT_SEED 1
#define DEFAULT_LATTICE 10

// ---- Generators with arguments ------------------------------------------------------------------

#define RADIUS                                                                                     \
    "a radius from " NUMBER_TEXT(SCENE3D_MIN_RADIUS) " to " NUMBER_TEXT(SCENE3D_MAX_RADIUS)

// "random" or "random:...".
static int random_open(const char *name, Scene3D *scene)
{
    int64_t n_spheres = DEFAULT_SPHERES;
    int64_t seed = DEFAULT_SEED;
    float min_radius = 0;  // 0 until the user gives one
    float max_radius = 0;
    const SceneArgument takes[] = {
        {"n=", "n=N, a whole number from 0 to " NUMBER_TEXT(SCENE3D_MAX_SPHERES),
         .whole = {&n_spheres, 0, SCENE3D_MAX_SPHERES}},
        {"seed=", "seed=S, a whole number of at least 0", .whole = {&seed, 0, INT64_MAX}},
        {"min=", "min=R, " RADIUS, .real = {&min_radius, SCENE3D_MIN_RADIUS, SCENE3D_MAX_RADIUS}},
        {"max=", "max=R, " RADIUS, .real = {&max_radius, SCENE3D_MIN_RADIUS, SCENE3D_MAX_RADIUS}},
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
        {"size=", "size=N, a whole number from 0 to " NUMBER_TEXT(SCENE3D_MAX_FLAKE_SIZE),
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
        {"n=", "n=N, a whole number from 1 to " NUMBER_TEXT(SCENE3D_MAX_LATTICE),
         .whole = {&n_per_side, 1, SCENE3D_MAX_LATTICE}},
        {.name = NULL},
    };
    if (scene_arguments_read(name, takes, "n=N") != 0) {
        return -1;
    }
    return scene3d_lattice((int)n_per_side, scene);
}

// "clusters" or "stadium", which take the same arguments.
static int uneven_open(const char *name, int make(int, uint64_t, Scene3D *), Scene3D *scene)
{
    int64_t n_spheres = DEFAULT_SPHERES;
    int64_t seed = DEFAULT_SEED;
    const SceneArgument takes[] = {
        {"n=", "n=N, a whole number from 0 to " NUMBER_TEXT(SCENE3D_MAX_SPHERES),
         .whole = {&n_spheres, 0, SCENE3D_MAX_SPHERES}},
        {"seed=", "seed=S, a whole number of at least 0", .whole = {&seed, 0, INT64_MAX}},
        {.name = NULL},
    };
    if (scene_arguments_read(name, takes, "n=N or seed=S") != 0) {
        return -1;
    }
    return make((int)n_spheres, (uint64_t)seed, scene);
}

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
    if (scene_is_called(name, "clusters")) {
        return uneven_open(name, scene3d_clusters, scene);
    }
    if (scene_is_called(name, "stadium")) {
        return uneven_open(name, scene3d_stadium, scene);
    }
    return scene_report_unknown(name, SCENE3D_NAMES, scene3d_edge_case);
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
