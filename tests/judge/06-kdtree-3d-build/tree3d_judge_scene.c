// The scenes over which the builders of labs 06 and 08 build trees: written, judged by what a check
// asks of a tree, and drawn for the report.
#include "tree3d_judge.h"

#include "job_sections.h"
#include "jobs.h"
#include "tree3d_draw.h"

// Without the expected tree.
static int write(const void *pointer, int k, FILE *file)
{
    const TreeScene3D *scene = pointer;
    const TreeJob3D job = {(u32)scene->scene.n_spheres, scene->limits.maxDepth,
                           scene->limits.targetElementsPerNode};
    const Sphere beyond = {.radius = BEYOND_RADIUS};
    return job_section_write(file, k, NULL, &job, sizeof job) |
           job_title_write(file, k, scene->title) |
           job_array_write(file, k, "spheres", scene->scene.spheres, (size_t)scene->scene.n_spheres,
                           &beyond, sizeof beyond);
}

static void release(void *pointer)
{
    TreeScene3D *scene = pointer;
    tree3d_free(&scene->tree);
    scene3d_free(&scene->scene);
}

const SceneKind tree3d_scene_kind = {write, release, 0};

int tree3d_is_refused(int k, const Sections *answers)
{
    return job_part_find(answers, "tree", k, "refused", 0) != NULL;
}

Verdict tree3d_judge_built(const TreeScene3D *scene, int k, const JudgeCheck *check,
                           const Sections *answers)
{
    KdTree3D own = {0};
    if (tree3d_judge_answer(k, answers, &own)) {
        return verdict_of(check->tree3d(scene, &own));
    }
    if (own.n_nodes > TREE3D_ANSWER_NODES || own.n_sphere_ids > TREE3D_ANSWER_IDS) {
        return verdict_of(diagnosis_new("%s, maxDepth %d: the tree has %u nodes and %u ids, "
                                        "expected %u and %u",
                                        scene->title, scene->limits.maxDepth, own.n_nodes,
                                        own.n_sphere_ids, scene->tree.n_nodes,
                                        scene->tree.n_sphere_ids));
    }
    return verdict_missing;
}

void tree3d_add_pictures(const void *job, const Sections *answers, Result *result)
{
    static const int drawn[] = {0, 2};
    for (int i = 0; i < COUNT(drawn) && result->n_pictures < RESULT_MAX_PICTURES; i++) {
        const TreeScene3D *scene = job_scene(job, drawn[i]);
        PictureResult *picture = &result->pictures[result->n_pictures++];
        KdTree3D own;
        snprintf(picture->title, sizeof picture->title, "cut through the tree over %s",
                 scene->title);
        tree3d_draw(&scene->scene, &scene->tree, &picture->reference);
        // Only what is packed as it should be can be followed. Lists do not matter to a drawing.
        if (!tree3d_is_refused(drawn[i], answers) && tree3d_judge_answer(drawn[i], answers, &own) &&
            verdict_passes(verdict_of(tree3d_judge_packing(scene, &own)))) {
            tree3d_draw(&scene->scene, &own, &picture->own);
        }
    }
}
