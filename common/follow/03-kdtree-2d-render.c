// What can be followed in lab 03: its own kernel, and the naive one of lab 01 beside it.
//
// Read next: world.h.
#include "kdtree2d_build.h"
#include "world.h"

static const WorldTree TREE = {.build.circles = kdtree2d_build};

static const WorldKernel KERNELS[] = {
    {
        .label = "kd-tree",
        .path = LAB_FOLDER "/implicit2DRenderer_KD.cl",
        .function = "implicit2DRenderer_KD",
        .tree = &TREE,
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/03-kdtree-2d-render.cl",
        .set_arguments = circles_set_tree,
    },
    {
        .label = "naive",
        .path = "solutions/01-naive-2d/implicit2DRenderer.cl",
        .function = "implicit2DRenderer",
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/01-naive-2d.cl",
        .set_arguments = circles_set_naive,
    },
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows circles; a pixel asks the circles of its kd-tree cell.",
    .kind = &CIRCLES,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
