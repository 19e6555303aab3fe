// Right answers of labs 04 and 05, in plain C; and the pictures of all 3D labs.
//
// Read next: right_answers_tree3d.h.
#ifndef UNIT_RIGHT_ANSWERS_3D_H
#define UNIT_RIGHT_ANSWERS_3D_H

#include "camera_from_view.h"
#include "image.h"
#include "jobs_04.h"
#include "jobs_05.h"
#include "jobs_10.h"
#include "right_answers_sections.h"
#include "vec3.h"

#include <math.h>

// The ray of a pixel; its t_min is 0.
typedef struct Ray {
    Vec3 origin, direction;
} Ray;

static Vec3 vec3_plus(Vec3 a, Vec3 b)
{
    return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static Vec3 on_display(int x, int y, int width, int height, float fov)
{
    const float size = fov / (float)width;
    return (Vec3){((float)x + 0.5f - 0.5f * (float)width) * size,
                  (0.5f * (float)height - (float)y - 0.5f) * size, 1};
}

static Ray primary_ray(int x, int y, int width, int height, const Camera *camera)
{
    const Vec3 p = on_display(x, y, width, height, camera->fov);
    const Vec3 in_plane = vec3_plus(vec3_scaled(camera->right, p.x), vec3_scaled(camera->up, p.y));
    return (Ray){camera->eye, vec3_normalized(vec3_plus(in_plane, camera->forward))};
}

static void answer_axes_and_pixels(Writer *writer, const Sections *job)
{
    size_t n_bytes;
    const ViewJob *views = sections_find_any(job, "views", &n_bytes);
    size_t n = n_bytes / sizeof *views;
    Vec3(*axes)[3] = calloc(n, sizeof *axes);
    for (size_t i = 0; i < n; i++) {
        const View view = {.from = views[i].from, .at = views[i].at, .up = views[i].up};
        camera_axes(view, &axes[i][0], &axes[i][1], &axes[i][2]);
    }
    answer(writer, "axes", axes, n * sizeof *axes);
    free(axes);

    const PixelJob *pixels = sections_find_any(job, "pixels", &n_bytes);
    n = n_bytes / sizeof *pixels;
    PixelAnswer *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const PixelJob p = pixels[i];
        const Ray ray = primary_ray(p.x, p.y, p.width, p.height, &p.camera);
        answers[i] = (PixelAnswer){on_display(p.x, p.y, p.width, p.height, p.camera.fov),
                                   ray.origin, ray.direction, 0, INFINITY};
    }
    answer(writer, "pixels", answers, n * sizeof *answers);
    free(answers);
}

static float nearest_root(float b, float disc, float radius, float t_min)
{
    if (disc < 0) {
        return INFINITY;
    }
    const float t_near = b - sqrtf(disc), t_far = b + sqrtf(disc);
    return t_near > t_min && radius > 0 ? t_near : t_far > t_min ? t_far : INFINITY;
}

static float intersect(Sphere sphere, Ray ray, float t_min)
{
    const Vec3 c = vec3_minus((Vec3){sphere.x, sphere.y, sphere.z}, ray.origin);
    const float b = vec3_dot(c, ray.direction);
    const Vec3 l = vec3_minus(c, vec3_scaled(ray.direction, b));
    return nearest_root(b, sphere.radius * sphere.radius - vec3_dot(l, l), sphere.radius, t_min);
}

static Vec3 surface_normal(Sphere sphere, Vec3 point, Vec3 direction)
{
    const Vec3 centre = {sphere.x, sphere.y, sphere.z};
    const Vec3 normal = vec3_normalized(vec3_minus(point, centre));
    return vec3_scaled(normal, vec3_dot(normal, direction) > 0 ? -1 : 1);
}

static Vec3 shade(Vec3 point, Vec3 normal, Material material, const Light *lights, int n_lights)
{
    Vec3 color = {0};
    for (int i = 0; i < n_lights; i++) {
        const Vec3 to_light = vec3_normalized(vec3_minus(lights[i].position, point));
        const float share = material.kd * fmaxf(0, vec3_dot(normal, to_light));
        color.x += share * material.color.x * lights[i].color.x;
        color.y += share * material.color.y * lights[i].color.y;
        color.z += share * material.color.z * lights[i].color.z;
    }
    return color;
}

static void answer_spheres(Writer *writer, const Sections *job, const char *name)
{
    size_t n_bytes;
    const SphereRayJob *inputs = sections_find_any(job, name, &n_bytes);
    const size_t n = n_bytes / sizeof *inputs;
    float *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const Ray ray = {inputs[i].origin, inputs[i].direction};
        answers[i] = intersect(inputs[i].sphere, ray, inputs[i].t_min);
    }
    answer(writer, name, answers, n * sizeof *answers);
    free(answers);
}

static void answer_sphere_functions(Writer *writer, const Sections *job)
{
    size_t n_bytes, n_light_bytes;
    const RootJob *roots = sections_find_any(job, "roots", &n_bytes);
    size_t n = n_bytes / sizeof *roots;
    float *distances = calloc(n, sizeof *distances);
    for (size_t i = 0; i < n; i++) {
        distances[i] = nearest_root(roots[i].b, roots[i].disc, roots[i].radius, roots[i].t_min);
    }
    answer(writer, "roots", distances, n * sizeof *distances);
    free(distances);
    answer_spheres(writer, job, "textbook");
    answer_spheres(writer, job, "projection");

    const NormalJob *points = sections_find_any(job, "normals", &n_bytes);
    n = n_bytes / sizeof *points;
    Vec3 *vectors = calloc(n, sizeof *vectors);
    for (size_t i = 0; i < n; i++) {
        vectors[i] = surface_normal(points[i].sphere, points[i].point, points[i].direction);
    }
    answer(writer, "normals", vectors, n * sizeof *vectors);
    free(vectors);

    const Light *lights = sections_find_any(job, "lights", &n_light_bytes);
    const ShadeJob *shades = sections_find_any(job, "shades", &n_bytes);
    n = n_bytes / sizeof *shades;
    vectors = calloc(n, sizeof *vectors);
    for (size_t i = 0; i < n; i++) {
        const ShadeJob in = shades[i];
        vectors[i] = shade(in.point, in.normal, in.material, lights + in.first_light, in.n_lights);
    }
    answer(writer, "shades", vectors, n * sizeof *vectors);
    free(vectors);
}
// ---- Scenes -------------------------------------------------------------------------------------

// A scene as the probe gets it: nothing in it is copied.
typedef struct SphereScene {
    const SceneJob3D *job;
    const Sphere *spheres;
    const u32 *material_ids;
    const Material *materials;
    const Light *lights;
    const KdNode3 *nodes;  // lab 07, else NULL
    const u32 *sphere_ids;
    const i32 *max_bounces;  // lab 09, else NULL
} SphereScene;

static const void *sphere_scene_part(const Sections *job, int k, const char *part)
{
    size_t n_bytes;
    return sections_find_any(job, numbered("scene", k, part), &n_bytes);
}

static int sphere_scene_read(const Sections *job, int k, SphereScene *scene)
{
    *scene = (SphereScene){
        .job = sections_find(job, numbered("scene", k, NULL), sizeof *scene->job),
        .spheres = sphere_scene_part(job, k, "spheres"),
        .material_ids = sphere_scene_part(job, k, "material_ids"),
        .materials = sphere_scene_part(job, k, "materials"),
        .lights = sphere_scene_part(job, k, "lights"),
        .nodes = sphere_scene_part(job, k, "nodes"),
        .sphere_ids = sphere_scene_part(job, k, "sphere_ids"),
        .max_bounces = sphere_scene_part(job, k, "bounces"),
    };
    return scene->job != NULL;
}

static const HitAnswer no_hit = {INFINITY, 0xffffffff};

// A way to find what a ray hits; it adds to *work what that costs.
typedef HitAnswer FindHit(const SphereScene *scene, Ray ray, Work *work);

// Lab 05: past all spheres.
static HitAnswer find_in_all(const SphereScene *scene, Ray ray, Work *work)
{
    HitAnswer hit = no_hit;
    for (int i = 0; i < scene->job->n_spheres; i++, work->n_tests++) {
        const float t = intersect(scene->spheres[i], ray, 0);
        if (t < hit.t) {
            hit = (HitAnswer){t, (u32)i};
        }
    }
    return hit;
}

// Lab 10: the same; of a tile only that spheres are asked counts, as there is an upper bound.
static HitAnswer find_for_nothing(const SphereScene *scene, Ray ray, Work *work)
{
    Work uncounted = *work;
    const HitAnswer hit = find_in_all(scene, ray, &uncounted);
    work->n_tests |= hit.t < INFINITY;
    return hit;
}

// The colour of a ray that hits this, or nothing.
typedef Vec3 ColorOfHit(const SphereScene *scene, Ray ray, HitAnswer hit);

static Vec3 hit_color(const SphereScene *scene, Ray ray, HitAnswer hit)
{
    if (hit.t == INFINITY) {
        return scene->job->background;
    }
    const Vec3 point = vec3_plus(ray.origin, vec3_scaled(ray.direction, hit.t));
    const Vec3 normal = surface_normal(scene->spheres[hit.sphere], point, ray.direction);
    return shade(point, normal, scene->materials[scene->material_ids[hit.sphere]], scene->lights,
                 scene->job->n_lights);
}

// The picture of scene k, in which a ray has the colour of what it hits, and the hits; with
// find_hit NULL that of its direction (lab 04). With has_work, the work besides.
static void answer_picture_3d(Writer *writer, int k, const SphereScene *scene, FindHit *find_hit,
                              ColorOfHit *color_of, int has_work)
{
    const int width = scene->job->width, height = scene->job->height;
    const int image_width = PROBE_IMAGE_SIDE(width);
    const size_t n_pixels = (size_t)image_width * PROBE_IMAGE_SIDE((size_t)height);
    float(*image)[IMAGE_CHANNELS] = malloc(n_pixels * sizeof *image);
    HitAnswer *hits = calloc(n_pixels, sizeof *hits);
    Work *work = calloc(n_pixels, sizeof *work);
    for (size_t i = 0; i < n_pixels * IMAGE_CHANNELS; i++) {
        image[i / IMAGE_CHANNELS][i % IMAGE_CHANNELS] = UNWRITTEN;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const int pixel = y * width + x;
            const Ray ray = primary_ray(x, y, width, height, &scene->job->camera);
            const Vec3 grey = {0.5f, 0.5f, 0.5f};
            Vec3 color = vec3_plus(vec3_scaled(ray.direction, 0.5f), grey);
            if (find_hit != NULL) {
                // Lab 10 counts at the first pixel of a tile.
                const int first = y / TILE_SIDE * TILE_SIDE * width + x / TILE_SIDE * TILE_SIDE;
                hits[pixel] =
                    find_hit(scene, ray, &work[find_hit == find_for_nothing ? first : pixel]);
                color = color_of(scene, ray, hits[pixel]);
            }
            memcpy(image[y * image_width + x], (float[]){color.x, color.y, color.z, 1},
                   sizeof *image);
        }
    }
    answer(writer, numbered("picture", k, NULL), image, n_pixels * sizeof *image);
    // Of lab 09 only the picture.
    if (color_of == hit_color) {
        answer(writer, numbered("hits", k, NULL), hits, (size_t)(width * height) * sizeof *hits);
    }
    if (has_work) {
        answer(writer, numbered("work", k, NULL), work, n_pixels * sizeof *work);
    }
    free(work);
    free(hits);
    free(image);
}

// The pictures of all scenes.
//   work_scenes[n_work_scenes]   those whose work is judged; NULL, 0 where it never is
static void answer_pictures_3d(Writer *writer, const Sections *job, FindHit *find_hit,
                               ColorOfHit *color_of, const int *work_scenes, int n_work_scenes)
{
    SphereScene scene;
    for (int k = 0; sphere_scene_read(job, k, &scene); k++) {
        int has_work = 0;
        for (int i = 0; i < n_work_scenes; i++) {
            has_work |= work_scenes[i] == k;
        }
        answer_picture_3d(writer, k, &scene, find_hit, color_of, has_work);
    }
}

#endif
