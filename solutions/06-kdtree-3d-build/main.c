// Lab 06: build the kd-tree over the spheres, print its figures and draw a cut through it. Nothing
// to fill in here; read it from top to bottom once, then go to kdtree3d_build.c.
//
// Flow: scene -> BUFFERS (the tree's arrays) -> kernel (lab 07) -> image; the banners below name
// the steps.
#include "image.h"
#include "kdtree3d_build.h"
#include "lab.h"
#include "scene3d.h"
#include "tree3d_draw.h"
#include "tree3d_report.h"

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME,
                        "Builds the kd-tree over spheres and draws a cut through it.",
                        OPTIONS_SCENE3D | OPTIONS_TREE);

    // ---- Scene, device ---------------------------------------------------------------------
    // A tree is built on the host: no device.
    Scene3D scene;
    require(scene3d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    lab_describe(&lab, "n_spheres", scene.n_spheres, scene.width, scene.height);

    // ---- Buffers ---------------------------------------------------------------------------
    const u32 n_spheres = (u32)scene.n_spheres;
    const KdTreeLimits limits =
        tree3d_limits(lab.options.max_depth, lab.options.leaf_size, n_spheres);
    stats_integer(&lab.stats, "max_depth", limits.maxDepth);
    stats_integer(&lab.stats, "leaf_size", limits.targetElementsPerNode);
    KdTree3D tree = {0};
    double *milliseconds = stats_times_create(lab.options.n_frames);
    for (int i = 0; i < lab.options.n_frames; i++) {
        tree3d_free(&tree);
        const double start = stats_clock_ms();
        require(kdtree3d_build(scene.spheres, n_spheres, limits, &tree));
        milliseconds[i] = stats_clock_ms() - start;
    }
    stats_milliseconds(&lab.stats, "tree.build", milliseconds, lab.options.n_frames);
    require(tree3d_check(&tree, n_spheres));
    require(tree3d_describe(&tree, &lab.stats));

    // ---- Kernel ----------------------------------------------------------------------------
    // None in this lab: lab 07 takes the tree's arrays to the device.

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(tree3d_draw(&scene, &tree, &image));
    require(image_save(&image, lab.options.output));

    free(milliseconds);
    image_free(&image);
    tree3d_free(&tree);
    scene3d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
