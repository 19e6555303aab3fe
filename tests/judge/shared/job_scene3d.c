// 3D scenes of a job: made from the seed or by name, written for the probe. What is expected of
// them is in job_scene3d_expected.c.
#include "job_scene3d.h"

#include "camera_from_view.h"
#include "complain.h"
#include "job_sections.h"
#include "jobs.h"
#include "message.h"
#include "random3d.h"
#include "scene_vary.h"

#include <stdlib.h>
#include <string.h>

// ---- Making -----------------------------------------------------------------------------------

// An array with room for one entry more. Returns 0, or -1 after one message.
static int array_extend(void **array, int n_entries, size_t entry_size)
{
    void *longer = realloc(*array, ((size_t)n_entries + 1) * entry_size);
    if (longer == NULL) {
        complain("grade: no memory for a scene");
        return -1;
    }
    *array = longer;
    return 0;
}

// Give a scene of scene3d.h its entries behind the ends. Returns 0, or -1 after one message.
static int finish(JobScene3D *scene)
{
    Scene3D *s = &scene->scene;
    void *spheres = s->spheres, *ids = s->material_ids, *materials = s->materials,
         *lights = s->lights;
    int result = array_extend(&spheres, s->n_spheres, sizeof *s->spheres);
    result |= array_extend(&ids, s->n_spheres, sizeof *s->material_ids);
    result |= array_extend(&materials, s->n_materials, sizeof *s->materials);
    result |= array_extend(&lights, s->n_lights, sizeof *s->lights);
    s->spheres = spheres, s->material_ids = ids, s->materials = materials, s->lights = lights;
    if (result == 0) {
        s->material_ids[s->n_spheres] = (u32)s->n_materials;
        s->materials[s->n_materials] =
            (Material){.color = {BEYOND_RED, BEYOND_GREEN, BEYOND_BLUE}, .kd = 1};
        job_scene3d_aim(scene);
    }
    return result;
}

void job_scene3d_aim(JobScene3D *scene)
{
    Scene3D *s = &scene->scene;
    const Vec3 eye = s->view.from;
    // Nearest of all: the eye is inside, and the light shines on it from there.
    const float radius = vec3_length(vec3_minus(s->view.at, eye)) / 1024;
    s->spheres[s->n_spheres] = (Sphere){eye.x, eye.y, eye.z, radius};
    s->lights[s->n_lights] = (Light){eye, {BEYOND_RED, BEYOND_GREEN, BEYOND_BLUE}};
    scene->camera = camera_from_view(s->view, s->width, s->height);
}

// Somewhere around the cube, its middle somewhere in the picture, any side up.
static void roll_view(Random *random, View *view)
{
    do {
        // Never near the middle, in any of the eight octants.
        const Vec3 way = vec3_normalized(random_vector(random, 0.25, 1));
        const float distance = random_number(random, 3, 5);
        view->from.x = distance * random_sign(random) * way.x;
        view->from.y = distance * random_sign(random) * way.y;
        view->from.z = distance * random_sign(random) * way.z;
        view->at = random_vector(random, -0.5, 0.5);
        view->up = random_vector(random, -2, 2);
        view->angle = random_number(random, 25, 55);
    } while (scene3d_view_fault(view) != NULL);
}

int job_scene3d_random(JobScene3D *scene, Random *random, int n_spheres, float min_radius,
                       float max_radius, int width, int height)
{
    *scene = (JobScene3D){0};
    snprintf(scene->picture.title, sizeof scene->picture.title, "random scene, %d sphere%s, %dx%d",
             n_spheres, plural((unsigned)n_spheres), width, height);
    Scene3D *s = &scene->scene;
    if (scene3d_random(n_spheres, random_bits(random), min_radius, max_radius, s) != 0) {
        return -1;
    }
    s->width = width, s->height = height;
    roll_view(random, &s->view);
    // What is the same everywhere would hide who forgets it.
    for (int i = 0; i < s->n_materials; i++) {
        s->materials[i].kd = random_number(random, 0.25, 1);
    }
    for (int i = 0; i < n_spheres; i++) {
        s->material_ids[i] = (u32)((i * 7 + 3) % s->n_materials);
    }
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].color = random_vector(random, 0.125, 0.75);
    }
    return finish(scene);
}

int job_scene3d_named(JobScene3D *scene, Random *random, const char *name, int width, int height)
{
    *scene = (JobScene3D){0};
    const int columns = side_vary(random, width), rows = side_vary(random, height);
    snprintf(scene->picture.title, sizeof scene->picture.title, "a scene like \"%s\", %dx%d", name,
             columns, rows);
    if (scene3d_generate(name, columns, rows, &scene->scene) != 0) {
        return -1;
    }
    scene3d_vary(&scene->scene, random);
    return finish(scene);
}

void job_scene3d_scale(JobScene3D *scene, float factor, const char *words)
{
    Scene3D *s = &scene->scene;
    char *title = scene->picture.title;
    const size_t length = strlen(title);
    snprintf(title + length, sizeof scene->picture.title - length, ", %s", words);
    for (int i = 0; i < s->n_spheres; i++) {
        const Sphere sphere = s->spheres[i];
        s->spheres[i] = (Sphere){factor * sphere.x, factor * sphere.y, factor * sphere.z,
                                 factor * sphere.radius};
    }
    for (int i = 0; i < s->n_lights; i++) {
        s->lights[i].position = vec3_scaled(s->lights[i].position, factor);
    }
    s->view.from = vec3_scaled(s->view.from, factor);
    s->view.at = vec3_scaled(s->view.at, factor);
    job_scene3d_aim(scene);
}

void job_scene3d_free(JobScene3D *scene)
{
    expected_picture_free(&scene->picture.expected);
    tree3d_free(&scene->tree);
    scene3d_free(&scene->scene);
    free(scene->hits);
    scene->hits = NULL;
}

int job_scene3d_write(const JobScene3D *scene, int k, FILE *file)
{
    const Scene3D *s = &scene->scene;
    const KdTree3D *tree = &scene->tree;
    const SceneJob3D job = {s->n_spheres,  s->n_lights,   s->width,    s->height,
                            s->background, scene->camera, tree->bounds};
    const size_t n_spheres = (size_t)s->n_spheres + 1, n_materials = (size_t)s->n_materials + 1,
                 n_lights = (size_t)s->n_lights + 1;
    int result = job_section_write(file, k, NULL, &job, sizeof job);
    result |= job_title_write(file, k, scene->picture.title);
    result |= job_section_write(file, k, "spheres", s->spheres, n_spheres * sizeof *s->spheres);
    result |= job_section_write(file, k, "material_ids", s->material_ids,
                                n_spheres * sizeof *s->material_ids);
    result |=
        job_section_write(file, k, "materials", s->materials, n_materials * sizeof *s->materials);
    result |= job_section_write(file, k, "lights", s->lights, n_lights * sizeof *s->lights);
    if (tree->n_nodes > 0) {
        result |=
            job_section_write(file, k, "nodes", tree->nodes, tree->n_nodes * sizeof *tree->nodes);
        result |= job_section_write(file, k, "sphere_ids", tree->sphere_ids,
                                    tree->n_sphere_ids * sizeof *tree->sphere_ids);
    }
    return result;
}

static int write(const void *scene, int k, FILE *file)
{
    return job_scene3d_write(scene, k, file);
}

static void release(void *scene)
{
    job_scene3d_free(scene);
}

const SceneKind job_scene3d_kind = {write, release, offsetof(JobScene3D, picture)};
