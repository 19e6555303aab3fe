// What can be followed in lab 05: its own kernel.
//
// Read next: world.h.
#include "world.h"

static const WorldKernel KERNELS[] = {
    {
        .label = "naive",
        .path = LAB_FOLDER "/render_spheres.cl",
        .function = "render_spheres",
        .options = KERNEL_OPTIONS,
        .steps_path = STEPS_FOLDER "/05-spheres.cl",
        .set_arguments = spheres_set_naive,
    },
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows spheres; every ray asks every sphere.",
    .kind = &SPHERES,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
