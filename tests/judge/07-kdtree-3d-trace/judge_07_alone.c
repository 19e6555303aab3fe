// Lab 07: each answer alone. clip_to_box, near_side, children_on_ray and search_leaf need no other
// task of the lab: their alone job is the sections that the whole job has for them. trace is tried
// on the scripted world of judge_07_script.h.
#include "judge_07.h"

#include "job_work.h"

#include <string.h>

int write_alone_07(const void *pointer, const char *task, FILE *file)
{
    const Job07 *job = pointer;
    int result = 0;
    for (int k = 0; strcmp(task, "trace") == 0 && result == 0 && k < N_SCRIPTED; k++) {
        result = job_scene3d_write(&job->scripted[k], k, file);
    }
    return result;
}

int hits_alone_07(const void *job, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job07 *)job)->scripted[k];
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const HitAnswer *found = hits_find(scene, k, answers);
    int passes = found != NULL;
    for (int i = 0; passes && i < n_pixels; i++) {
        const ScriptedSearch expected = scripted_07_search(scene, i % width, i / width);
        passes = found[i].t == expected.t && found[i].sphere == expected.sphere;
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

int work_alone_07(const void *job, int k, const Sections *answers)
{
    const JobScene3D *scene = &((const Job07 *)job)->scripted[k];
    const int width = scene->scene.width, n_pixels = width * scene->scene.height;
    const Work *found;
    int passes = verdict_passes(job_work_find(&scene->picture, k, "", "", answers, &found));
    for (int i = 0; passes && i < n_pixels; i++) {
        const ScriptedSearch expected = scripted_07_search(scene, i % width, i / width);
        passes = is_right_work(&expected, found[i]);
    }
    return passes;
}

int picture_alone_07(const void *job, int k, const Sections *answers)
{
    const JobPicture *picture = &((const Job07 *)job)->scripted[k].picture;
    const ProbeImage own = job_picture_answer(picture, k, answers);
    return own.pixels != NULL && picture_is_right(own, &picture->expected);
}
