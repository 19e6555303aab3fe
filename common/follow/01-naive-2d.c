// What can be followed in lab 01: its own kernel.
//
// Read next: world.h.
#include "world.h"

static const WorldKernel KERNELS[] = {
    {
        .label = "naive",
        .path = LAB_FOLDER "/implicit2DRenderer.cl",
        .function = "implicit2DRenderer",
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/01-naive-2d.cl",
        .set_arguments = circles_set_naive,
    },
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows circles; every pixel asks every circle.",
    .kind = &CIRCLES,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
