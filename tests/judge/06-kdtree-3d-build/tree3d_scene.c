// A scene over which the builders of labs 06 and 08 build a tree, as a job has it.
#include "tree3d_judge.h"

#include "job_sections.h"
#include "jobs.h"

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
