// The window of lab 07: its own kernel, and the naive one of lab 05 beside it.
//
// Flow: SCENE -> BUFFERS -> KERNEL -> IMAGE -> comparison. Read next: view.c.
#include "kdtree3d_build.h"
#include "view.h"

int main(int argc, char **argv)
{
    const WorldKernel kernels[] = {
        {
            .label = "kd-tree",
            .path = LAB_FOLDER "/render_kdtree.cl",
            .function = "render_kdtree",
            .options = KERNEL_OPTIONS,
            .steps_path = STEPS_FOLDER "/07-kdtree-3d-trace.cl",
            .set_arguments = spheres_set_tree,
        },
        {
            .label = "naive",
            .path = "solutions/05-spheres/render_spheres.cl",
            .function = "render_spheres",
            .options = KERNEL_OPTIONS,
            .steps_path = STEPS_FOLDER "/05-spheres.cl",
            .set_arguments = spheres_set_naive,
        },
    };
    const ViewLab view_lab = {
        .name = LAB_NAME,
        .what = "Shows spheres; a ray asks the spheres of the kd-tree cells it meets.",
        .kind = &SPHERES,
        .build.spheres = kdtree3d_build,
        .has_tree = 1,
        .kernels = kernels,
        .n_kernels = sizeof kernels / sizeof kernels[0],
    };
    return view_run(argc, argv, &view_lab);
}
