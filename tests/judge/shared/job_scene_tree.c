// The tree of a job's scene, as lab 02 delivers it. A file of its own, because a handout of lab
// 02 or before has no solution to build it with.
#include "job_scene.h"

#include "kdtree2d_build.h"

int job_scene_grow_tree(JobScene *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    return kdtree2d_build(scene->scene.circles, (u32)scene->scene.n_circles, limits, &scene->tree);
}
