// See job_scene_tree.h.
#include "job_scene_tree.h"

#include "kdtree2d_build.h"

int job_scene_grow_tree(JobScene *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    return kdtree2d_build(scene->scene.circles, (u32)scene->scene.n_circles, limits, &scene->tree);
}
