// What there is to see in lab 04: the rays' directions as colours.
//
// Read next: world.h.
#include "world.h"

static const WorldKernel KERNELS[] = {
    {
        .label = "directions",
        .path = LAB_FOLDER "/draw_directions.cl",
        .function = "draw_directions",
        .options = KERNEL_OPTIONS,
        .not_followed = "rays that ask nothing: none is followed",
        .set_arguments = rays_set_directions,
    },
};

const WorldLab WORLD_LAB = {
    .name = LAB_NAME,
    .what = "Shows the directions of the rays as colours.",
    .kind = &RAYS,
    .kernels = KERNELS,
    .n_kernels = sizeof KERNELS / sizeof KERNELS[0],
};
