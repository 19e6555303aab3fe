// The window of lab 01: its own kernel.
//
// Flow: SCENE -> BUFFERS -> KERNEL -> IMAGE -> comparison. Read next: view.c.
#include "view.h"

int main(int argc, char **argv)
{
    const WorldKernel kernels[] = {
        {
            .label = "naive",
            .path = LAB_FOLDER "/implicit2DRenderer.cl",
            .function = "implicit2DRenderer",
            .options = KERNEL_OPTIONS,
            .steps_path = STEPS_FOLDER "/01-naive-2d.cl",
            .set_arguments = circles_set_naive,
        },
    };
    const ViewLab view_lab = {
        .name = LAB_NAME,
        .what = "Shows circles; every pixel asks every circle.",
        .kind = &CIRCLES,
        .kernels = kernels,
        .n_kernels = sizeof kernels / sizeof kernels[0],
    };
    return view_run(argc, argv, &view_lab);
}
