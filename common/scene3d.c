// 3D scenes: room for one, and what completes it (see scene3d.h).
//
// Generators and readers stand on this file; it knows none of them. Read next: scene3d_generate.c.
#include "scene3d.h"

#include "complain.h"
#include "scene_arguments.h"

#include <math.h>
#include <stdlib.h>

#define DEFAULT_ANGLE 45  // degrees

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

// ---- Completing a scene -------------------------------------------------------------------------

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
