// Lab 05: each answer alone, beside stand-ins where it calls another task's function (see
// tests/stand_ins/README.md).
//
// nearest_root, surface_normal and the three checks of shade that call it need no other task: their
// alone job is the section that the whole job has for them. nearest_hit is in judge_05_squares.c.
#include "judge_05.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static const OracleRules3D right = {0};

static int is_task(const char *task, const char *id)
{
    return strcmp(task, id) == 0;
}

// ---- intersect_textbook, intersect_sphere -------------------------------------------------------

// The same spheres as in the whole, but hits count from t_min on, which has many values: the
// stand-in shows whether it is handed on.
static void set_t_min(SphereRayJob *jobs, int n)
{
    for (int i = 0; i < n; i++) {
        jobs[i].t_min = (float)(i % 9) / 16;
    }
}

// The inputs of the alone job. Owned by the caller; NULL when there is no memory.
static Inputs05 *alone_inputs(const Inputs05 *whole)
{
    Inputs05 *inputs = malloc(sizeof *inputs);
    if (inputs != NULL) {
        *inputs = *whole;
        set_t_min(inputs->textbook, COUNT(inputs->textbook));
        set_t_min(inputs->projection, COUNT(inputs->projection));
    }
    return inputs;
}

// What stands in the hole of nearest_root, in double: the larger b and disc, the larger it is.
static double stand_in_root(double b, double disc, double radius, double t_min)
{
#include "05-spheres/nearest_root.cl"
}

// Does an answer follow from a right call of the stand-in? The chord says in which intervals a
// right solution's b and sqrt(disc) lie. Of its four terms 2 sqrt(disc), 4 radius and 8 t_min are
// exact products, and each of the three sums costs one rounding of at most the sum of all sizes.
static int follows(const SphereRayJob *job, OracleForm form, float found)
{
    const double rounding = 3 * 0x1p-24;
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    const OracleChord chord = oracle3d_chord(job->sphere, &ray, form);
    if (isinf(found) && found > 0) {
        return !chord.is_certain;
    }
    const double radius = job->sphere.radius, t_min = job->t_min;
    const double size = stand_in_root(fabs(chord.middle) + chord.error,
                                      chord.longest * chord.longest, fabs(radius), t_min);
    const double low =
        stand_in_root(chord.middle - chord.error, chord.shortest * chord.shortest, radius, t_min);
    const double high =
        stand_in_root(chord.middle + chord.error, chord.longest * chord.longest, radius, t_min);
    return chord.is_possible && found >= low - rounding * size && found <= high + rounding * size;
}

// A clear miss need not be handed to nearest_root: INFINITY is right then, whatever that gives.
static int is_clear_miss(const SphereRayJob *job, OracleForm form, float found)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    return isinf(found) && found > 0 && !oracle3d_root(job->sphere, &ray, form, &right).is_certain;
}

static int all_follow(const SphereRayJob *jobs, int n, OracleForm form, const float *found)
{
    int i = 0;
    while (i < n &&
           (follows(&jobs[i], form, found[i]) || is_clear_miss(&jobs[i], form, found[i]))) {
        i++;
    }
    return i == n;
}

// Do the answers of a range follow from the stand-in, or are they right without it? Nobody has to
// call nearest_root.
static int pass_spheres(const Job05 *job, int check, const Sections *answers)
{
    Inputs05 *inputs = alone_inputs(&job->inputs);
    if (inputs == NULL) {
        return 0;
    }
    const int is_textbook = check < SPHERE_NEAR;
    const int range = check - (is_textbook ? TEXTBOOK_OUTSIDE : SPHERE_NEAR);
    const int first = range * N_SPHERE_INPUTS;
    const SphereRayJob *jobs = is_textbook ? inputs->textbook : inputs->projection;
    const float *found =
        sections_find(answers, is_textbook ? "textbook" : "projection",
                      sizeof *found * (size_t)(is_textbook ? COUNT(inputs->textbook)
                                                           : COUNT(inputs->projection)));
    int passes = 0;
    if (found != NULL) {
        Verdict (*const judge_truth)(const Inputs05 *, int, const Sections *) =
            is_textbook ? inputs_05_judge_textbook : inputs_05_judge_projection;
        passes = verdict_passes(judge_truth(inputs, range, answers)) ||
                 all_follow(jobs + first, N_SPHERE_INPUTS,
                            is_textbook ? ORACLE_TEXTBOOK : ORACLE_PROJECTION, found + first);
    }
    free(inputs);
    return passes;
}

static int write_spheres(const Job05 *job, const char *task, FILE *file)
{
    Inputs05 *inputs = alone_inputs(&job->inputs);
    int result = -1;
    if (inputs != NULL) {
        result =
            is_task(task, "intersect_textbook")
                ? section_write(file, "textbook", inputs->textbook, sizeof inputs->textbook)
                : section_write(file, "projection", inputs->projection, sizeof inputs->projection);
    }
    free(inputs);
    return result;
}

// ---- shade --------------------------------------------------------------------------------------

// The calls of shade in the whole pictures, as a right solution makes them. The lights of the
// scenes stand behind those of the function's inputs, with the one of each that must not shine.
typedef struct PixelShades {
    ShadeJob *jobs;  // owned
    Light *lights;   // owned
    int n_jobs, n_lights;
} PixelShades;

static void pixel_shades_free(PixelShades *shades)
{
    free(shades->jobs);
    free(shades->lights);
}

static Vec3 rounded(OracleVector v)
{
    return (Vec3){(float)v.x, (float)v.y, (float)v.z};
}

// The call for a pixel whose hit is certain. Returns 0 when its normal is not.
static int shade_job(const JobScene3D *scene, int pixel, ShadeJob *job)
{
    const Scene3D *s = &scene->scene;
    const OracleHit *hit = &scene->hits[pixel];
    const OracleRay ray = oracle3d_primary_ray(&scene->camera, pixel % s->width, pixel / s->width,
                                               s->width, s->height, &right);
    const OracleNear direction = {ray.direction, ray.direction_error};
    const OracleNear point = {{ray.origin.x + hit->t * ray.direction.x,
                               ray.origin.y + hit->t * ray.direction.y,
                               ray.origin.z + hit->t * ray.direction.z},
                              hit->t_tolerance};
    const OracleNear normal = oracle3d_normal(s->spheres[hit->sphere], point, direction, &right);
    *job = (ShadeJob){.point = rounded(point.value),
                      .normal = rounded(normal.value),
                      .material = s->materials[s->material_ids[hit->sphere]],
                      .n_lights = s->n_lights};
    return !isinf(normal.error);
}

static void add_scene(const JobScene3D *scene, PixelShades *shades)
{
    const Scene3D *s = &scene->scene;
    for (int pixel = 0; pixel < s->width * s->height; pixel++) {
        const OracleHit *hit = &scene->hits[pixel];
        ShadeJob *job = &shades->jobs[shades->n_jobs];
        if (hit->sphere != ORACLE_NO_SPHERE && !hit->is_ambiguous && shade_job(scene, pixel, job)) {
            job->first_light = shades->n_lights;
            shades->n_jobs++;
        }
    }
    const int n_lights = s->n_lights + 1;
    memcpy(shades->lights + shades->n_lights, s->lights, (size_t)n_lights * sizeof *s->lights);
    shades->n_lights += n_lights;
}

// Returns 0, or -1 when there is no memory. Free it in either case.
static int pixel_shades_list(const Job05 *job, PixelShades *shades)
{
    size_t n_pixels = 0, n_lights = N_LIGHTS;
    for (int k = 0; k < N_SCENES; k++) {
        const Scene3D *s = &job->scenes[k].scene;
        n_pixels += (size_t)s->width * (size_t)s->height;
        n_lights += (size_t)s->n_lights + 1;
    }
    *shades = (PixelShades){malloc(n_pixels * sizeof(ShadeJob)), malloc(n_lights * sizeof(Light)),
                            0, N_LIGHTS};
    if (shades->jobs == NULL || shades->lights == NULL) {
        return -1;
    }
    memcpy(shades->lights, job->inputs.lights, sizeof job->inputs.lights);
    for (int k = 0; k < N_SCENES; k++) {
        add_scene(&job->scenes[k], shades);
    }
    return 0;
}

static int write_shades(const Job05 *job, FILE *file)
{
    PixelShades shades;
    int result = pixel_shades_list(job, &shades);
    if (result == 0) {
        result |= section_write(file, "shades", job->inputs.shades, sizeof job->inputs.shades);
        result |= section_write(file, "pixel_shades", shades.jobs,
                                (size_t)shades.n_jobs * sizeof *shades.jobs);
        result |= section_write(file, "lights", shades.lights,
                                (size_t)shades.n_lights * sizeof *shades.lights);
    }
    pixel_shades_free(&shades);
    return result;
}

static OracleNear exactly(Vec3 v)
{
    return (OracleNear){{v.x, v.y, v.z}, 0};
}

static int is_right_shade(const PixelShades *shades, int i, Vec3 found)
{
    const ShadeJob *job = &shades->jobs[i];
    const OracleNear color =
        oracle3d_shade(exactly(job->point), exactly(job->normal), &job->material,
                       shades->lights + job->first_light, job->n_lights, &right);
    return fabs(found.x - color.value.x) <= color.error &&
           fabs(found.y - color.value.y) <= color.error &&
           fabs(found.z - color.value.z) <= color.error;
}

static int pass_pixel_shades(const Job05 *job, const Sections *answers)
{
    PixelShades shades;
    int passes = pixel_shades_list(job, &shades) == 0;
    const Vec3 *found =
        passes ? sections_find(answers, "pixel_shades", (size_t)shades.n_jobs * sizeof *found)
               : NULL;
    passes = found != NULL;
    for (int i = 0; passes && i < shades.n_jobs; i++) {
        passes = is_right_shade(&shades, i, found[i]);
    }
    pixel_shades_free(&shades);
    return passes;
}

// ---- All ----------------------------------------------------------------------------------------

int alone_05_write(const void *pointer, const char *task, FILE *file)
{
    const Job05 *job = pointer;
    if (is_task(task, "nearest_root")) {
        return section_write(file, "roots", job->inputs.roots, sizeof job->inputs.roots);
    }
    if (is_task(task, "surface_normal")) {
        return section_write(file, "normals", job->inputs.normals, sizeof job->inputs.normals);
    }
    if (is_task(task, "shade")) {
        return write_shades(job, file);
    }
    return is_task(task, "nearest_hit") ? squares_05_write(job->squares, file)
                                        : write_spheres(job, task, file);
}

int alone_05_passes(const void *pointer, int check, const Sections *answers)
{
    const Job05 *job = pointer;
    switch (check) {
    case TEXTBOOK_OUTSIDE:
    case TEXTBOOK_INSIDE:
    case SPHERE_NEAR:
    case SPHERE_INSIDE:
    case SPHERE_FAR_SMALL:
        return pass_spheres(job, check, answers);
    case HIT_NEAREST:
        return squares_05_pass_hits(job->squares, RANDOM, 3, answers);
    case HIT_TIES:
        return squares_05_pass_hits(job->squares, TIES, 1, answers);
    case HIT_EDGES:
        return squares_05_pass_hits(job->squares, EDGES, N_EDGES, answers);
    case HIT_WORK:
        return squares_05_pass_work(job->squares, answers);
    case SHADE_PICTURE:
        return pass_pixel_shades(job, answers);
    default:
        return verdict_passes(judge_05_check(job, check, answers));
    }
}
