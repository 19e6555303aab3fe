// What can be followed in lab 08: lab 07's kernel through its own tree, and through lab 06's; and
// the naive kernel of lab 05 beside them.
//
// Read next: world.h.
#include "kdtree3d_build.h"
#include "kdtree3d_sah.h"
#include "world.h"

// As main.c of the lab has them: cost knows by itself where to stop.
static KdTreeLimits by_cost_limits(int max_depth, int leaf_size, u32 n_elements)
{
    (void)n_elements;
    return (KdTreeLimits){max_depth > 0 ? max_depth : TODO_SIZE + 1, leaf_size > 0 ? leaf_size : 1};
}

static const WorldTree BY_COST = {.build.spheres = kdtree3d_build_sah, .limits = by_cost_limits};
static const WorldTree MIDDLE = {.build.spheres = kdtree3d_build, .limits = tree3d_limits};

static const WorldKernel KERNELS[] = {
    {
        .label = "by cost",
        .path = "solutions/07-kdtree-3d-trace/render_kdtree.cl",
        .function = "render_kdtree",
        .tree = &BY_COST,
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/08-surface-area-heuristic.cl",
        .set_arguments = spheres_set_tree,
    },
    {
        .label = "middle",
        .path = "solutions/07-kdtree-3d-trace/render_kdtree.cl",
        .function = "render_kdtree",
        .tree = &MIDDLE,
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/08-surface-area-heuristic.cl",
        .set_arguments = spheres_set_tree,
    },
    SPHERES_NAIVE_KERNEL,
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows spheres through a kd-tree that is built by cost, and through lab 06's.",
    .kind = &SPHERES,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
