// 2D scenes that are made, by name (scene2d_generate() of scene2d.h).
//
// Read next: scene2d_random.c and scene2d_edge_cases.c for the generators.
#include "number.h"
#include "scene2d_edge_cases.h"
#include "scene_arguments.h"

#include <stdlib.h>
#include <string.h>

#define DEFAULT_SEED 1
#define DEFAULT_MIN_RADIUS 2.0f
#define DEFAULT_MAX_RADIUS 20.0f

#define RADIUS "a radius from 0 to " NUMBER_TEXT(SCENE2D_MAX_RADIUS)

// "random" or "random:...".
static int random_open(const char *name, Scene2D *scene)
{
    int64_t n_circles = SCENE2D_DEFAULT_CIRCLES;
    int64_t seed = DEFAULT_SEED;
    float min_radius = DEFAULT_MIN_RADIUS;
    float max_radius = DEFAULT_MAX_RADIUS;
    const SceneArgument takes[] = {
        {"n=", "n=N, a whole number from 0 to " NUMBER_TEXT(SCENE2D_MAX_CIRCLES),
         .whole = {&n_circles, 0, SCENE2D_MAX_CIRCLES}},
        {"seed=", "seed=S, a whole number of at least 0", .whole = {&seed, 0, INT64_MAX}},
        {"min=", "min=R, " RADIUS, .real = {&min_radius, 0, SCENE2D_MAX_RADIUS}},
        {"max=", "max=R, " RADIUS, .real = {&max_radius, 0, SCENE2D_MAX_RADIUS}},
        {.name = NULL},
    };
    if (scene_arguments_read(name, takes, "n=N, seed=S, min=R or max=R") != 0 ||
        scene_arguments_check_radii(name, min_radius, max_radius) != 0) {
        return -1;
    }
    return scene2d_random((int)n_circles, (uint64_t)seed, min_radius, max_radius, scene->width,
                          scene->height, scene);
}

static int edge_case_open(const SceneEdgeCase *edge_case, Scene2D *scene)
{
    if (scene2d_create(SCENE2D_EDGE_CASE_CIRCLES, scene->width, scene->height, scene) != 0) {
        return -1;
    }
    scene->n_circles = 0;
    edge_case->draw(scene);
    if (scene->n_circles == 0) {
        free(scene->circles);
        scene->circles = NULL;
    }
    return 0;
}

static const SceneEdgeCase *edge_case_find(const char *name)
{
    for (const SceneEdgeCase *edge_case = SCENE2D_EDGE_CASES; edge_case->name != NULL;
         edge_case++) {
        if (strcmp(edge_case->name, name) == 0) {
            return edge_case;
        }
    }
    return NULL;
}

int scene2d_generate(const char *name, int width, int height, Scene2D *scene)
{
    const SceneEdgeCase *edge_case = edge_case_find(name);
    int size_is_given = width > 0 && height > 0;
    *scene = (Scene2D){.width = SCENE2D_DEFAULT_SIZE, .height = SCENE2D_DEFAULT_SIZE};
    if (size_is_given) {
        scene->width = width;
        scene->height = height;
    } else if (edge_case != NULL && edge_case->width > 0) {
        scene->width = edge_case->width;
        scene->height = edge_case->height;
    }

    if (edge_case != NULL) {
        return edge_case_open(edge_case, scene);
    }
    if (scene_is_called(name, "random")) {
        return random_open(name, scene);
    }
    return scene_report_unknown(name, SCENE2D_NAMES, scene2d_edge_case);
}

const char *scene2d_edge_case(int index)
{
    return SCENE2D_EDGE_CASES[index].name;
}
