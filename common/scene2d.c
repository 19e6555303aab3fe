// 2D scenes: room for one (see scene2d.h).
//
// Generators stand on this file; it knows none of them. Read next: scene2d_generate.c.
#include "scene2d.h"

#include "scene_arguments.h"

#include <stdlib.h>

int scene2d_create(int n_circles, int width, int height, Scene2D *scene)
{
    *scene = (Scene2D){.width = width, .height = height};
    if (n_circles == 0) {
        return 0;
    }
    scene->circles = calloc((size_t)n_circles, sizeof *scene->circles);
    if (scene->circles == NULL) {
        return scene_report_memory();
    }
    scene->n_circles = n_circles;
    return 0;
}

void scene2d_free(Scene2D *scene)
{
    free(scene->circles);
    *scene = (Scene2D){0};
}
