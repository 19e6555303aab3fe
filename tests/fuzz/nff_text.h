// A scene as text in the Neutral File Format: what the reader must read back to the same bits.
//
// For the fuzzer of the readers and for their unit tests. It shares nothing with the reader.
#ifndef FUZZ_NFF_TEXT_H
#define FUZZ_NFF_TEXT_H

#include "scene3d.h"

#include <string.h>

// One line: a keyword and numbers. Nine digits bring every float back.
//   numbers   an object that holds nothing but floats, n_numbers of them from its beginning
static inline void nff_line_write(FILE *file, const char *keyword, const void *numbers,
                                  int n_numbers)
{
    fputs(keyword, file);
    for (int i = 0; i < n_numbers; i++) {
        float number;
        memcpy(&number, (const char *)numbers + (size_t)i * sizeof number, sizeof number);
        fprintf(file, " %.9g", (double)number);
    }
    fputc('\n', file);
}

// The reader numbers materials in the order in which it meets them, and keeps one of equal ones: so
// all stand in front of the spheres, and each sphere's own once more before it.
static inline void nff_write(FILE *file, const Scene3D *scene)
{
    const View *view = &scene->view;
    nff_line_write(file, "b", &scene->background, 3);
    fputs("v\n", file);
    nff_line_write(file, "from", &view->from, 3);
    nff_line_write(file, "at", &view->at, 3);
    nff_line_write(file, "up", &view->up, 3);
    nff_line_write(file, "angle", &view->angle, 1);
    nff_line_write(file, "hither", &view->hither, 1);
    fprintf(file, "resolution %d %d\n", scene->width, scene->height);
    for (int i = 0; i < scene->n_lights; i++) {
        nff_line_write(file, "l", &scene->lights[i], 6);
    }
    for (int i = 0; i < scene->n_materials; i++) {
        nff_line_write(file, "f", &scene->materials[i], 8);
    }
    for (int i = 0; i < scene->n_spheres; i++) {
        nff_line_write(file, "f", &scene->materials[scene->material_ids[i]], 8);
        nff_line_write(file, "s", &scene->spheres[i], 4);
    }
}

#endif
