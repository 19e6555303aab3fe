// The tree of a job's 3D scene, as lab 06 delivers it. A file of its own, because a handout of lab
// 06 or before has no solution to build it with.
#include "job_scene3d.h"

#include "kdtree3d_build.h"

int job_scene3d_grow_tree(JobScene3D *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    return kdtree3d_build(scene->scene.spheres, (u32)scene->scene.n_spheres, limits, &scene->tree);
}
