// Lab 02: build the kd-tree over the circles, print it and draw it. Nothing to fill in here; read
// it from top to bottom once, then go to kdtree2d_build.c.
//
// Flow: scene -> BUFFERS (the tree's four arrays) -> kernel (lab 03) -> image; the banners below
// name the steps.
#include "image.h"
#include "kdtree2d_build.h"
#include "lab.h"
#include "scene2d.h"
#include "tree2d_draw.h"
#include "tree2d_report.h"

#include <stdio.h>

// The lecture's example, with numbers of ours: which cells contain pixel (7, 7)?
static void print_worked_example(void)
{
    const KdTreeLimits limits = {.maxDepth = 4, .targetElementsPerNode = 1};
    Scene2D scene;
    KdTree2D tree = {0};
    require(scene2d_open("example", 0, 0, &scene));
    require(kdtree2d_build(scene.circles, (u32)scene.n_circles, limits, &tree));
    require(tree2d_check(&tree, (u32)scene.n_circles));
    printf("Worked example: circles A to E are 0 to 4, maxDepth 4, targetElementsPerNode 1.\n");
    tree2d_print_cells(&tree, 7, 7);
    tree2d_free(&tree);
    scene2d_free(&scene);
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Lab lab = lab_begin(argc, argv, LAB_NAME, "Builds the kd-tree over circles and draws it.",
                        OPTIONS_SCENE | OPTIONS_TREE);

    // ---- Scene, device ---------------------------------------------------------------------
    // A tree is built on the host: no device.
    Scene2D scene;
    require(scene2d_open(lab.options.scene, lab.options.width, lab.options.height, &scene));
    lab_describe(&lab, "n_circles", scene.n_circles, scene.width, scene.height);
    print_worked_example();  // a scene of its own

    // ---- Buffers ---------------------------------------------------------------------------
    const u32 n_circles = (u32)scene.n_circles;
    const KdTreeLimits limits = {lab.options.max_depth, lab.options.leaf_size};
    stats_integer(&lab.stats, "max_depth", limits.maxDepth);
    stats_integer(&lab.stats, "leaf_size", limits.targetElementsPerNode);
    KdTree2D tree = {0};
    double *milliseconds = stats_times_create(lab.options.n_frames);
    for (int i = 0; i < lab.options.n_frames; i++) {
        tree2d_free(&tree);
        const double start = stats_clock_ms();
        require(kdtree2d_build(scene.circles, n_circles, limits, &tree));
        milliseconds[i] = stats_clock_ms() - start;
    }
    stats_milliseconds(&lab.stats, "tree.build", milliseconds, lab.options.n_frames);
    require(tree2d_check(&tree, n_circles));
    require(tree2d_describe(&tree, &lab.stats));

    // ---- Kernel ----------------------------------------------------------------------------
    // None in this lab: lab 03 takes the tree's arrays to the device.

    // ---- Image -----------------------------------------------------------------------------
    Image image;
    require(tree2d_draw(&scene, &tree, &image));
    require(tree2d_save(&image, &scene, &tree, lab.options.output));

    free(milliseconds);
    image_free(&image);
    tree2d_free(&tree);
    scene2d_free(&scene);
    lab_end(&lab);
    return EXIT_SUCCESS;
}
