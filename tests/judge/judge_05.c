// Judge of lab 05: each function on chosen inputs, and what rays hit in whole scenes. What the
// functions' inputs are, and what is expected of them, is in judge_05_inputs.c; how answers are
// tried alone in judge_05_alone.c.
#include "judge_05.h"

#include "job_sections.h"
#include "message.h"
#include "work.h"

#include <math.h>
#include <stdlib.h>

static const Check checks[] = {
    [ROOT_NEARER] = {"root-nearer", "Where the ray enters, or no hit", "nearest_root", 5},
    [ROOT_INSIDE] = {"root-inside", "Where it leaves, from inside and for negative radii",
                     "nearest_root", 5},
    [ROOT_T_MIN] = {"root-t_min", "Only beyond t_min", "nearest_root", 5},
    [TEXTBOOK_OUTSIDE] = {"textbook-outside", "Spheres before the eye, and misses",
                          "intersect_textbook", 5, "nearest_root"},
    [TEXTBOOK_INSIDE] = {"textbook-inside", "Spheres around the eye and behind it",
                         "intersect_textbook", 5, "nearest_root"},
    [SPHERE_NEAR] = {"sphere-near", "Spheres before the eye, and misses", "intersect_sphere", 8,
                     "nearest_root"},
    [SPHERE_INSIDE] = {"sphere-inside", "Spheres around the eye and behind it", "intersect_sphere",
                       5, "nearest_root"},
    [SPHERE_FAR_SMALL] = {"sphere-far-small", "Small spheres far away", "intersect_sphere", 12,
                          "nearest_root"},
    [HIT_NEAREST] = {"hit-nearest", "Random scenes", "nearest_hit", 8,
                     "intersect_sphere nearest_root"},
    [HIT_TIES] = {"hit-ties", "Of equal distances the lower index wins", "nearest_hit", 4,
                  "intersect_sphere nearest_root"},
    [HIT_EDGES] = {"hit-edges", "Inside, behind, large and small, one, none", "nearest_hit", 4,
                   "intersect_sphere nearest_root"},
    [HIT_WORK] = {"hit-work", "Every sphere is asked once", "nearest_hit", 4},
    [NORMAL_UNIT] = {"normal-unit", "From the centre to the point, a unit vector", "surface_normal",
                     5},
    [NORMAL_INSIDE] = {"normal-inside", "Seen from inside, towards the eye", "surface_normal", 5},
    [SHADE_LAMBERT] = {"shade-lambert", "kd x cosine x colours, one light", "shade", 6},
    [SHADE_BEHIND] = {"shade-behind", "A light behind the surface adds nothing", "shade", 4},
    [SHADE_LIGHTS] = {"shade-lights", "All lights, and no more", "shade", 5},
    [SHADE_PICTURE] = {"shade-picture", "Whole pictures", "shade", 5,
                       "nearest_hit intersect_sphere nearest_root surface_normal"},
};

static const char *const edge_names[N_EDGES] = {"inside", "behind", "large-small", "one", "none"};

// ---- Drawing the job --------------------------------------------------------------------------

static int draw_scenes(Random *random, JobScene3D scenes[N_SCENES])
{
    int result = job_scene3d_random(&scenes[RANDOM], random, 60, 0.125f, 0.375f, 96, 64);
    result |= job_scene3d_random(&scenes[RANDOM + 1], random, 100, 0.0625f, 0.25f, 49, 67);
    result |= job_scene3d_named(&scenes[FLAKE], "sphereflake:size=2", 64, 64);
    result |= job_scene3d_named(&scenes[TIES], "coincident", 64, 48);
    for (int i = 0; i < N_EDGES; i++) {
        result |= job_scene3d_named(&scenes[EDGES + i], edge_names[i], 48, 36);
    }
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        result = job_scene3d_expect(&scenes[k]);
    }
    return result;
}

static void job_free(void *pointer)
{
    Job05 *job = pointer;
    for (int k = 0; k < N_SCENES; k++) {
        job_scene3d_free(&job->scenes[k]);
    }
    free(job);
}

static void *job_new(uint64_t seed, FILE *file)
{
    Random random = {seed};
    Job05 *job = calloc(1, sizeof *job);
    if (job == NULL) {
        fprintf(stderr, "grade: no memory for a job\n");
        return NULL;
    }
    inputs_05_draw(&random, &job->inputs);
    int result = inputs_05_write(&job->inputs, file) | draw_scenes(&random, job->scenes);
    squares_05_draw(&random, job->squares);
    for (int k = 0; result == 0 && k < N_SCENES; k++) {
        job->pictures[k] = &job->scenes[k].picture;
        result = job_scene3d_write(&job->scenes[k], k, file);
    }
    if (result != 0) {
        job_free(job);
        return NULL;
    }
    return job;
}

// ---- Judging ----------------------------------------------------------------------------------

// Every pixel asks every sphere, once.
static Verdict judge_work(const Job05 *job, const Sections *answers)
{
    const JobScene3D *scene = &job->scenes[WORK];
    const int width = scene->scene.width, height = scene->scene.height;
    const Work *found = job_section_find(answers, "work", WORK,
                                         (size_t)PROBE_IMAGE_SIDE(width) *
                                             (size_t)PROBE_IMAGE_SIDE(height) * sizeof *found);
    if (found == NULL) {
        if (job_picture_answer(&scene->picture, WORK, answers).pixels == NULL) {
            return verdict_missing;
        }
        return verdict_of(message_new("the work could not be counted; call intersect_sphere in "
                                      "nearest_hit itself"));
    }
    for (int pixel = 0; pixel < width * height; pixel++) {
        const u32 n_tests = found[pixel].n_tests;
        if (n_tests != (u32)scene->scene.n_spheres) {
            return verdict_of(message_new("%s: the ray of pixel (%d, %d): intersect_sphere was "
                                          "called %u times, but the scene has %d spheres",
                                          scene->picture.title, pixel % width, pixel / width,
                                          n_tests, scene->scene.n_spheres));
        }
    }
    return verdict_of(NULL);
}

Verdict judge_05_check(const void *pointer, int check, const Sections *answers)
{
    const Job05 *job = pointer;
    switch (check) {
    case ROOT_NEARER:
        return inputs_05_judge_roots(&job->inputs, 0, answers);
    case ROOT_INSIDE:
        return inputs_05_judge_roots(&job->inputs, 1, answers);
    case ROOT_T_MIN:
        return inputs_05_judge_roots(&job->inputs, 2, answers);
    case TEXTBOOK_OUTSIDE:
        return inputs_05_judge_textbook(&job->inputs, 0, answers);
    case TEXTBOOK_INSIDE:
        return inputs_05_judge_textbook(&job->inputs, 1, answers);
    case SPHERE_NEAR:
        return inputs_05_judge_projection(&job->inputs, 0, answers);
    case SPHERE_INSIDE:
        return inputs_05_judge_projection(&job->inputs, 1, answers);
    case SPHERE_FAR_SMALL:
        return inputs_05_judge_projection(&job->inputs, 2, answers);
    case HIT_NEAREST:
        return job_scenes3d_judge_hits(job->scenes, RANDOM, 3, answers);
    case HIT_TIES:
        return job_scenes3d_judge_hits(job->scenes, TIES, 1, answers);
    case HIT_EDGES:
        return job_scenes3d_judge_hits(job->scenes, EDGES, N_EDGES, answers);
    case HIT_WORK:
        return judge_work(job, answers);
    case NORMAL_UNIT:
        return inputs_05_judge_normals(&job->inputs, 0, answers);
    case NORMAL_INSIDE:
        return inputs_05_judge_normals(&job->inputs, 1, answers);
    case SHADE_LAMBERT:
        return inputs_05_judge_shades(&job->inputs, 0, answers);
    case SHADE_BEHIND:
        return inputs_05_judge_shades(&job->inputs, 1, answers);
    case SHADE_LIGHTS:
        return inputs_05_judge_shades(&job->inputs, 2, answers);
    default:
        return job_pictures_judge(job->pictures, 0, N_SCENES, answers);
    }
}

// The oracle's pictures stay the reference: a right solution may be as far from them as ours is, on
// the other side.
static void adopt(void *job, const Sections *answers)
{
    (void)job, (void)answers;
}

static void add_pictures(const void *pointer, const Sections *answers, Result *result)
{
    const Job05 *job = pointer;
    job_pictures_report(job->pictures, N_SCENES, answers, result);
}

const Judge judge_05 = {
    .lab = "05-spheres",
    .checks = checks,
    .n_checks = sizeof checks / sizeof *checks,
    .job_new = job_new,
    .job_free = job_free,
    .judge = judge_05_check,
    .write_alone = alone_05_write,
    .passes_alone = alone_05_passes,
    .adopt = adopt,
    .add_pictures = add_pictures,
};
