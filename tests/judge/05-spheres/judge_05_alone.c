// Lab 05: each answer alone, beside stubs where it calls another task's function (see
// tests/stubs/README.md).
//
// nearest_root, surface_normal and the three checks of shade that call it need no other task: their
// alone job is the section that the whole job has for them. nearest_hit is in judge_05_squares.c.
#include "judge_05.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const OracleRules3D right = {0};

// ---- intersect_textbook, intersect_sphere -------------------------------------------------------

// The same spheres as in the whole, but hits count from t_min on, which has many values: the
// stub shows whether it is handed on. Edges whose t_min is not 0 keep it.
static void set_t_min(SphereRayJob *jobs, int n)
{
    for (int i = 0; i < n; i++) {
        jobs[i].t_min = jobs[i].t_min == 0 ? (float)(i % 9) / 16 : jobs[i].t_min;
    }
}

// The job with the inputs of the alone job; what it points at is the whole job's. Release it with
// free(); NULL when there is no memory.
static Job05 *alone_job(const Job05 *whole)
{
    Job05 *job = malloc(sizeof *job);
    if (job != NULL) {
        *job = *whole;
        inputs_05_link(job);
        set_t_min(job->textbook, COUNT(job->textbook));
        set_t_min(job->projection, COUNT(job->projection));
    }
    return job;
}

// What stands in the hole of nearest_root, in double: the larger b and disc, the larger it is.
static double stub_root(double b, double disc, double radius, double t_min, u32 NONCE)
{
#include "05-spheres/nearest_root.cl"
}

// Does an answer follow from a right call of the stub? The chord says in which intervals a
// right solution's b and sqrt(disc) lie. Of its four terms 2 sqrt(disc) is an exact product, and
// the two other products and the three sums cost one rounding each of at most the sum of all sizes.
static int follows(const SphereRayJob *job, OracleForm form, float found, u32 nonce)
{
    const double rounding = 5 * 0x1p-24;
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    const OracleChord chord = oracle3d_chord(job->sphere, &ray, form);
    if (touches_exactly_05(job)) {
        return found == stub_root(chord.middle, 0, job->sphere.radius, job->t_min, nonce);
    }
    if (isinf(found) && found > 0) {
        return !chord.is_certain;
    }
    const double radius = job->sphere.radius, t_min = job->t_min;
    const double size = stub_root(fabs(chord.middle) + chord.error, chord.longest * chord.longest,
                                  fabs(radius), t_min, nonce);
    const double low = stub_root(chord.middle - chord.error, chord.shortest * chord.shortest,
                                 radius, t_min, nonce);
    const double high =
        stub_root(chord.middle + chord.error, chord.longest * chord.longest, radius, t_min, nonce);
    return chord.is_possible && found >= low - rounding * size && found <= high + rounding * size;
}

// A clear miss need not be handed to nearest_root: INFINITY is right then, whatever that gives.
static int is_clear_miss(const SphereRayJob *job, OracleForm form, float found)
{
    const OracleRay ray = oracle3d_given_ray(job->origin, job->direction, job->t_min);
    return isinf(found) && found > 0 && !touches_exactly_05(job) &&
           !oracle3d_root(job->sphere, &ray, form, &right).is_certain;
}

static int all_follow(const SphereRayJob *jobs, int n, OracleForm form, const float *found,
                      u32 nonce)
{
    int i = 0;
    while (i < n &&
           (follows(&jobs[i], form, found[i], nonce) || is_clear_miss(&jobs[i], form, found[i]))) {
        i++;
    }
    return i == n;
}

// Do the answers of a range follow from the stub, or are they right without it? Nobody has to
// call nearest_root.
int spheres_alone_05(const void *whole, const JudgeCheck *check, const Sections *answers)
{
    const float *found = function_answers(check->function, answers);
    Job05 *job = found != NULL ? alone_job(whole) : NULL;
    if (job == NULL) {
        return 0;
    }
    const Range range = check->range;
    const int is_textbook = check->function == &textbook_05;
    const int passes = verdict_passes(function_judge(check->function, job, range, answers)) ||
                       all_follow((is_textbook ? job->textbook : job->projection) + range.first,
                                  range.n, is_textbook ? ORACLE_TEXTBOOK : ORACLE_PROJECTION,
                                  found + range.first, job->job.nonce);
    free(job);
    return passes;
}

Cause spheres_cause_05(const void *whole, const JudgeCheck *check, const Sections *answers)
{
    Job05 *job = alone_job(whole);
    if (job == NULL) {
        return (Cause){0};
    }
    job->of_textbook.root = job->of_sphere.root = stub_root;
    job->of_textbook.nonce = job->of_sphere.nonce = job->job.nonce;
    const Function *function =
        check->function == &textbook_05 ? &textbook_alone_05 : &projection_alone_05;
    const Cause cause = function_cause(function, job, check->range, answers);
    free(job);
    return cause;
}

static int write_spheres(const Job05 *whole, int is_textbook, FILE *file)
{
    Job05 *job = alone_job(whole);
    const int result =
        job == NULL   ? -1
        : is_textbook ? section_write(file, "textbook", job->textbook, sizeof job->textbook)
                      : section_write(file, "projection", job->projection, sizeof job->projection);
    free(job);
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

// The call for a pixel whose hit is certain. Returns 0 when its normal is not.
static int shade_job(const JobScene3D *scene, int pixel, ShadeJob *job)
{
    const Scene3D *s = &scene->scene;
    const OracleHit *hit = &scene->hits[pixel];
    const OracleRay ray = job_scene3d_ray(scene, pixel);
    const OracleNear direction = {ray.direction, ray.direction_error};
    const OracleNear point = {{ray.origin.x + hit->t * ray.direction.x,
                               ray.origin.y + hit->t * ray.direction.y,
                               ray.origin.z + hit->t * ray.direction.z},
                              hit->t_tolerance};
    const OracleNear normal = oracle3d_normal(s->spheres[hit->sphere], point, direction, &right);
    *job = (ShadeJob){.point = vector_rounded(point.value),
                      .normal = vector_rounded(normal.value),
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
    memcpy(shades->lights, job->lights, sizeof job->lights);
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
        result = section_write(file, "pixel_shades", shades.jobs,
                               (size_t)shades.n_jobs * sizeof *shades.jobs) |
                 section_write(file, "lights", shades.lights,
                               (size_t)shades.n_lights * sizeof *shades.lights);
    }
    pixel_shades_free(&shades);
    return result;
}

static int is_right_shade(const PixelShades *shades, int i, Vec3 found)
{
    const ShadeJob *job = &shades->jobs[i];
    return oracle3d_is_near(found, oracle3d_shade(oracle3d_exactly(job->point),
                                                  oracle3d_exactly(job->normal), &job->material,
                                                  shades->lights + job->first_light, job->n_lights,
                                                  &right));
}

int pixel_shades_05(const void *job, const JudgeCheck *check, const Sections *answers)
{
    PixelShades shades;
    const int is_listed = pixel_shades_list(job, &shades) == 0;
    const Vec3 *found =
        is_listed ? sections_find(answers, "pixel_shades", (size_t)shades.n_jobs * sizeof *found)
                  : NULL;
    int passes = found != NULL;
    (void)check;
    for (int i = 0; passes && i < shades.n_jobs; i++) {
        passes = is_right_shade(&shades, i, found[i]);
    }
    pixel_shades_free(&shades);
    return passes;
}

// ---- All ----------------------------------------------------------------------------------------

int write_alone_05(const void *pointer, const char *task, FILE *file)
{
    const Job05 *job = pointer;
    if (strcmp(task, "shade") == 0) {
        return write_shades(job, file);
    }
    if (strcmp(task, "nearest_hit") == 0) {
        return squares_05_write(job->squares, file);
    }
    const int is_textbook = strcmp(task, "intersect_textbook") == 0;
    return is_textbook || strcmp(task, "intersect_sphere") == 0
               ? write_spheres(job, is_textbook, file)
               : 0;
}
