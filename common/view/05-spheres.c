// The window of lab 05: its own kernel.
//
// Flow: SCENE -> BUFFERS -> KERNEL -> IMAGE -> comparison. Read next: view.c.
#include "view.h"

int main(int argc, char **argv)
{
    const WorldKernel kernels[] = {
        {
            .label = "naive",
            .path = LAB_FOLDER "/render_spheres.cl",
            .function = "render_spheres",
            .options = KERNEL_OPTIONS,
            .steps_path = STEPS_FOLDER "/05-spheres.cl",
            .set_arguments = spheres_set_naive,
        },
    };
    const ViewLab view_lab = {
        .name = LAB_NAME,
        .what = "Shows spheres; every ray asks every sphere.",
        .kind = &SPHERES,
        .kernels = kernels,
        .n_kernels = sizeof kernels / sizeof kernels[0],
    };
    return view_run(argc, argv, &view_lab);
}
