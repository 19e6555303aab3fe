// What can be followed in lab 07: its own kernel, and the naive one of lab 05 beside it.
//
// Read next: world.h.
#include "kdtree3d_build.h"
#include "world.h"

static const WorldTree TREE = {.build.spheres = kdtree3d_build, .limits = tree3d_limits};

static const WorldKernel KERNELS[] = {
    {
        .label = "kd-tree",
        .path = LAB_FOLDER "/render_kdtree.cl",
        .function = "render_kdtree",
        .tree = &TREE,
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/07-kdtree-3d-trace.cl",
        .set_arguments = spheres_set_tree,
    },
    SPHERES_NAIVE_KERNEL,
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows spheres; a ray asks the spheres of the kd-tree cells it meets.",
    .kind = &SPHERES,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
