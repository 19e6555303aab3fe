// Lab 07: each answer alone. clip_to_box, near_side, children_on_ray and search_leaf need no other
// task of the lab: their alone job is the sections that the whole job has for them. trace is tried
// on the scripted world of judge_07_script.h.
#include "judge_07.h"

#include "job_sections.h"

#include <stdlib.h>
#include <string.h>

static int write_leaves(const Inputs07 *inputs, FILE *file)
{
    int result = section_write(file, "leaves", inputs->leaves, sizeof inputs->leaves);
    result |= section_write(file, "leaf_ids", inputs->leaf_ids, sizeof inputs->leaf_ids);
    return result |
           section_write(file, "leaf_spheres", inputs->leaf_spheres, sizeof inputs->leaf_spheres);
}

int alone_07_write(const void *pointer, const char *task, FILE *file)
{
    const Job07 *job = pointer;
    const Inputs07 *inputs = &job->inputs;
    if (strcmp(task, "clip_to_box") == 0) {
        return section_write(file, "clips", inputs->clips, sizeof inputs->clips);
    }
    if (strcmp(task, "near_side") == 0) {
        return section_write(file, "sides", inputs->sides, sizeof inputs->sides);
    }
    if (strcmp(task, "children_on_ray") == 0) {
        return section_write(file, "planes", inputs->planes, sizeof inputs->planes);
    }
    if (strcmp(task, "search_leaf") == 0) {
        return write_leaves(inputs, file);
    }
    int result = 0;
    for (int k = 0; result == 0 && k < N_SCRIPTED; k++) {
        result = job_scene3d_write(&job->scripted[k], k, file);
    }
    return result;
}

static int pass_hits(const Job07 *job, int first, int n, const Sections *answers)
{
    int passes = 1;
    for (int k = first; passes && k < first + n; k++) {
        const JobScene3D *scene = &job->scripted[k];
        const int width = scene->scene.width, n_pixels = width * scene->scene.height;
        const HitAnswer *found =
            job_section_find(answers, "hits", k, (size_t)n_pixels * sizeof *found);
        passes = found != NULL;
        for (int i = 0; passes && i < n_pixels; i++) {
            const ScriptedSearch expected = scripted_07_search(scene, i % width, i / width);
            passes = found[i].t == expected.t && found[i].sphere == expected.sphere;
        }
    }
    return passes;
}

// As the whole has it: empty leaves need not be searched, and one place on the stack is granted to
// who puts the near child there as well. The stand-in of search_leaf counts a leaf's spheres.
static int is_right_work(const ScriptedSearch *expected, Work found)
{
    const Work most = expected->work;
    return found.n_tests == most.n_tests && found.n_nodes_visited == most.n_nodes_visited &&
           found.n_leaves_visited <= most.n_leaves_visited &&
           found.n_leaves_visited >= most.n_leaves_visited - expected->n_empty &&
           found.stack_depth <= most.stack_depth + 1 && found.stack_depth <= TODO_SIZE;
}

static int pass_work(const Job07 *job, const Sections *answers)
{
    int passes = 1;
    for (int k = 0; passes && k < N_SCRIPTED; k++) {
        const JobScene3D *scene = &job->scripted[k];
        const int width = scene->scene.width, height = scene->scene.height;
        const Work *found = job_section_find(answers, "work", k,
                                             (size_t)PROBE_IMAGE_SIDE(width) *
                                                 (size_t)PROBE_IMAGE_SIDE(height) * sizeof *found);
        passes = found != NULL;
        for (int i = 0; passes && i < width * height; i++) {
            const ScriptedSearch expected = scripted_07_search(scene, i % width, i / width);
            passes = is_right_work(&expected, found[i]);
        }
    }
    return passes;
}

static int pass_pictures(const Job07 *job, const Sections *answers)
{
    int passes = 1;
    for (int k = 0; passes && k < N_SCRIPTED; k++) {
        const JobPicture *picture = &job->scripted[k].picture;
        const ProbeImage own = job_picture_answer(picture, k, answers);
        passes = own.pixels != NULL && picture_is_right(own, &picture->expected);
    }
    return passes;
}

int alone_07_passes(const void *pointer, int check, const Sections *answers)
{
    const Job07 *job = pointer;
    switch (check) {
    case TRACE_RANDOM:
        return pass_hits(job, SCRIPTED_RANDOM, SCRIPTED_EDGES, answers);
    case TRACE_EDGES:
        return pass_hits(job, SCRIPTED_EDGES, N_SCRIPTED - SCRIPTED_EDGES, answers);
    case TRACE_EARLY_END:
        return pass_work(job, answers);
    case TRACE_PICTURE:
        return pass_pictures(job, answers);
    default:
        return verdict_passes(judge_07_check(job, check, answers));
    }
}
