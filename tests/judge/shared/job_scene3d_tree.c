// See job_scene3d_tree.h.
#include "job_scene3d_tree.h"

#include "kdtree3d_build.h"

int job_scene3d_grow_tree(JobScene3D *scene, KdTreeLimits limits)
{
    scene->limits = limits;
    return kdtree3d_build(scene->scene.spheres, (u32)scene->scene.n_spheres, limits, &scene->tree);
}
