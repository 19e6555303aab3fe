// 2D scenes by name: the way from the word after --scene to circles (see scene2d.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Read next: scene2d_csv.c for files,
// scene2d_random.c and scene2d_edge_cases.c for the generators.
#include "scene2d.h"

#include "number.h"
#include "scene2d_generate.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define RANDOM_NAME "random"
#define DEFAULT_SEED 1
#define DEFAULT_MIN_RADIUS 2.0f
#define DEFAULT_MAX_RADIUS 20.0f

// The arguments of "random:n=100,seed=3,min=2,max=20".
typedef struct RandomArguments {
    int64_t n_circles;
    int64_t seed;
    float min_radius;
    float max_radius;
} RandomArguments;

static int report(const char *scene_name, const char *argument, const char *expected)
{
    fprintf(stderr, "--scene %s: found \"%s\", expected %s\n", scene_name, argument, expected);
    return -1;
}

static int argument_is(const char *argument, const char *name, const char **value)
{
    size_t length = strlen(name);
    *value = argument + length;
    return strncmp(argument, name, length) == 0;
}

static int radius_read(const char *text, float *radius)
{
    float value;
    if (number_read_float(text, &value) != 0 || !(value >= 0 && value <= SCENE2D_MAX_RADIUS)) {
        return -1;
    }
    *radius = value;
    return 0;
}

// Take in one "name=value". Returns what was expected instead, or NULL when all is well.
static const char *argument_read(const char *argument, RandomArguments *arguments)
{
    const char *value;
    if (argument_is(argument, "n=", &value)) {
        if (number_read_integer(value, 0, SCENE2D_MAX_CIRCLES, &arguments->n_circles) != 0) {
            return "n=N, a whole number from 0 to 10000000";
        }
    } else if (argument_is(argument, "seed=", &value)) {
        if (number_read_integer(value, 0, INT64_MAX, &arguments->seed) != 0) {
            return "seed=S, a whole number of at least 0";
        }
    } else if (argument_is(argument, "min=", &value)) {
        if (radius_read(value, &arguments->min_radius) != 0) {
            return "min=R, a radius from 0 to 255";
        }
    } else if (argument_is(argument, "max=", &value)) {
        if (radius_read(value, &arguments->max_radius) != 0) {
            return "max=R, a radius from 0 to 255";
        }
    } else {
        return "n=N, seed=S, min=R or max=R";
    }
    return NULL;
}

_Static_assert(SCENE2D_MAX_CIRCLES == 10000000 && SCENE2D_MAX_RADIUS == 255,
               "the messages above name these limits");

// Read "n=100,seed=3"; `list` is cut up. Returns 0, or -1 after one message.
static int arguments_read(const char *scene_name, char *list, RandomArguments *arguments)
{
    for (char *argument = list; argument != NULL;) {
        char *comma = strchr(argument, ',');
        if (comma != NULL) {
            *comma = '\0';
        }
        const char *expected = argument_read(argument, arguments);
        if (expected != NULL) {
            return report(scene_name, argument, expected);
        }
        argument = comma == NULL ? NULL : comma + 1;
    }
    if (arguments->min_radius > arguments->max_radius) {
        fprintf(stderr, "--scene %s: found min=%g above max=%g, expected at most that\n",
                scene_name, (double)arguments->min_radius, (double)arguments->max_radius);
        return -1;
    }
    return 0;
}

// "random" or "random:...".
static int random_open(const char *name, Scene2D *scene)
{
    RandomArguments arguments = {SCENE2D_DEFAULT_CIRCLES, DEFAULT_SEED, DEFAULT_MIN_RADIUS,
                                 DEFAULT_MAX_RADIUS};
    const char *colon = strchr(name, ':');
    if (colon != NULL) {
        char *list = strdup(colon + 1);
        int result =
            list == NULL ? scene2d_report_memory() : arguments_read(name, list, &arguments);
        free(list);
        if (result != 0) {
            return -1;
        }
    }
    return scene2d_random((int)arguments.n_circles, (uint64_t)arguments.seed, arguments.min_radius,
                          arguments.max_radius, scene->width, scene->height, scene);
}

static int edge_case_open(const SceneEdgeCase *edge_case, Scene2D *scene)
{
    scene->circles = calloc(SCENE2D_EDGE_CASE_CIRCLES, sizeof *scene->circles);
    if (scene->circles == NULL) {
        return scene2d_report_memory();
    }
    edge_case->draw(scene);
    if (scene->n_circles == 0) {
        free(scene->circles);
        scene->circles = NULL;
    }
    return 0;
}

static int csv_open(const char *path, Scene2D *scene)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be read: %s\n", path, strerror(errno));
        return -1;
    }
    int result = scene2d_read_csv(file, path, scene);
    fclose(file);
    return result;
}

static int report_unknown(const char *name)
{
    fprintf(stderr,
            "--scene %s: found no such scene, expected FILE.csv, " RANDOM_NAME
            "[:n=N,seed=S,min=R,max=R]",
            name);
    for (int i = 0; scene2d_edge_case(i) != NULL; i++) {
        fprintf(stderr, ", %s", scene2d_edge_case(i));
    }
    fprintf(stderr, "\n");
    return -1;
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

static int ends_in_csv(const char *name)
{
    size_t length = strlen(name);
    return length > 4 && strcmp(name + length - 4, ".csv") == 0;
}

int scene2d_open(const char *name, int width, int height, Scene2D *scene)
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
    if (ends_in_csv(name)) {
        return csv_open(name, scene);
    }
    if (strcmp(name, RANDOM_NAME) == 0 || strncmp(name, RANDOM_NAME ":", 7) == 0) {
        return random_open(name, scene);
    }
    return report_unknown(name);
}

void scene2d_free(Scene2D *scene)
{
    free(scene->circles);
    *scene = (Scene2D){0};
}

int scene2d_report_memory(void)
{
    fprintf(stderr, "scene: no memory\n");
    return -1;
}

const char *scene2d_edge_case(int index)
{
    return SCENE2D_EDGE_CASES[index].name;
}
