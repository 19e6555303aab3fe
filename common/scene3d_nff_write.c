// 3D scenes written in the Neutral File Format (scene3d_write_nff() of scene3d.h).
//
// Flow: SCENE -> buffers -> kernel -> image -> comparison. Every number is written so that the
// reader finds the same float again. Read next: number.h.
#include "number.h"
#include "scene3d.h"

#include <string.h>

// One line: a keyword and numbers.
//   numbers   an object that holds nothing but floats, n_numbers of them from its beginning
static void line_write(FILE *file, const char *keyword, const void *numbers, int n_numbers)
{
    fputs(keyword, file);
    for (int i = 0; i < n_numbers; i++) {
        float number;
        char text[NUMBER_TEXT_SIZE];
        memcpy(&number, (const char *)numbers + (size_t)i * sizeof number, sizeof number);
        number_write_float(number, text);
        fprintf(file, " %s", text);
    }
    fputc('\n', file);
}

static void view_write(FILE *file, const Scene3D *scene)
{
    const View *view = &scene->view;
    fputs("v\n", file);
    line_write(file, "from", &view->from, 3);
    line_write(file, "at", &view->at, 3);
    line_write(file, "up", &view->up, 3);
    line_write(file, "angle", &view->angle, 1);
    line_write(file, "hither", &view->hither, 1);
    fprintf(file, "resolution %d %d\n", scene->width, scene->height);
}

static void materials_write(FILE *file, const Scene3D *scene, int first, int end)
{
    for (int i = first; i < end; i++) {
        line_write(file, "f", &scene->materials[i], 8);
    }
}

// The reader numbers materials in the order in which it meets them. So each is written before a
// sphere needs it or a later one, and once more where spheres return to it.
static void spheres_write(FILE *file, const Scene3D *scene)
{
    int n_written = 0;  // materials met so far
    int current = -1;   // the last one
    for (int i = 0; i < scene->n_spheres; i++) {
        const int wanted = (int)scene->material_ids[i];
        if (wanted >= n_written) {
            materials_write(file, scene, n_written, wanted + 1);
            n_written = wanted + 1;
        } else if (wanted != current) {
            materials_write(file, scene, wanted, wanted + 1);
        }
        current = wanted;
        line_write(file, "s", &scene->spheres[i], 4);
    }
    materials_write(file, scene, n_written, scene->n_materials);
}

int scene3d_write_nff(FILE *file, const Scene3D *scene)
{
    line_write(file, "b", &scene->background, 3);
    view_write(file, scene);
    for (int i = 0; i < scene->n_lights; i++) {
        line_write(file, "l", &scene->lights[i], 6);
    }
    spheres_write(file, scene);
    return ferror(file) ? -1 : 0;
}
