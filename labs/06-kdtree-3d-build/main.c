// Lab 06: build the kd-tree over the spheres, print its figures and draw a cut through it. Nothing
// to fill in here; read it from top to bottom once, then go to kdtree3d_build.c.
//
// Flow: scene -> BUFFERS (the tree's arrays) -> kernel (lab 07) -> image -> comparison.
#include "image.h"
#include "kdtree3d_build.h"
#include "options.h"
#include "scene3d.h"
#include "stats.h"
#include "tree3d_draw.h"

#include <stdio.h>
#include <stdlib.h>

// Trees of up to this many nodes are printed node by node.
enum { MAX_PRINTED_NODES = 63 };

// One line for a node: its plane and its children, or its spheres.
static void print_node(const KdTree3D *tree, u32 id)
{
    const KdNode3 node = tree->nodes[id];
    if (node.split_axis != KD_LEAF) {
        printf("  node %3u  split at %c = %g, children %u and %u\n", id, "xyz"[node.split_axis],
               (double)node.split_pos, node.first, node.first + 1);
        return;
    }
    printf("  node %3u  leaf, %u %s:", id, node.n_spheres,
           node.n_spheres == 1 ? "sphere" : "spheres");
    for (u32 i = 0; i < node.n_spheres; i++) {
        printf(" %u", tree->sphere_ids[node.first + i]);
    }
    printf("\n");
}

// The tree's figures, and its nodes where they are few. Returns 0, or -1 after one message.
static int describe(const KdTree3D *tree, Stats *stats)
{
    TreeFigures3D figures;
    if (tree3d_figures(tree, &figures) != 0) {
        return -1;
    }
    stats_integer(stats, "tree.n_nodes", tree->n_nodes);
    stats_integer(stats, "tree.n_leaves", figures.n_leaves);
    stats_integer(stats, "tree.n_empty_leaves", figures.n_empty);
    stats_integer(stats, "tree.depth", figures.depth);
    stats_integer(stats, "tree.n_sphere_ids", tree->n_sphere_ids);
    stats_integer(stats, "tree.largest_leaf", figures.largest_leaf);
    stats_number(stats, "tree.spheres_per_leaf", (double)tree->n_sphere_ids / figures.n_leaves);
    if (tree->n_nodes <= MAX_PRINTED_NODES) {
        printf("The tree in x [%g, %g], y [%g, %g], z [%g, %g]:\n", (double)tree->bounds.min[0],
               (double)tree->bounds.max[0], (double)tree->bounds.min[1],
               (double)tree->bounds.max[1], (double)tree->bounds.min[2],
               (double)tree->bounds.max[2]);
        for (u32 id = 0; id < tree->n_nodes; id++) {
            print_node(tree, id);
        }
    }
    return 0;
}

// Build as often as --frames says and note how long it takes; keeps the last tree. Returns 0, or -1
// after one message.
static int build(const Options *options, const Scene3D *scene, KdTree3D *tree, Stats *stats)
{
    const u32 n_spheres = (u32)scene->n_spheres;
    const KdTreeLimits limits = tree3d_limits(options->max_depth, options->leaf_size, n_spheres);
    double *milliseconds = stats_times_create(options->n_frames);
    int result = 0;
    stats_integer(stats, "max_depth", limits.maxDepth);
    stats_integer(stats, "leaf_size", limits.targetElementsPerNode);
    for (int i = 0; result == 0 && i < options->n_frames; i++) {
        tree3d_free(tree);
        const double start = stats_clock_ms();
        result = kdtree3d_build(scene->spheres, n_spheres, limits, tree);
        milliseconds[i] = stats_clock_ms() - start;
    }
    if (result == 0) {
        result = tree3d_check(tree, n_spheres);
    }
    if (result == 0) {
        stats_milliseconds(stats, "tree.build", milliseconds, options->n_frames);
    }
    free(milliseconds);
    return result;
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Options options;
    switch (options_parse(argc, argv, LAB_NAME,
                          "Builds the kd-tree over spheres and draws a cut through it.",
                          OPTIONS_SCENE3D | OPTIONS_TREE, &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }

    // ---- Scene -----------------------------------------------------------------------------
    Scene3D scene = {0};
    KdTree3D tree = {0};
    Image image = {0};
    Stats stats = {0};
    int result = scene3d_open(options.scene, options.width, options.height, &scene);
    if (result == 0) {
        stats_text(&stats, "lab", LAB_NAME);
        stats_text(&stats, "scene", options.scene);
        stats_integer(&stats, "n_spheres", scene.n_spheres);
        stats_integer(&stats, "width", scene.width);
        stats_integer(&stats, "height", scene.height);
    }

    // ---- Tree ------------------------------------------------------------------------------
    if (result == 0) {
        result = build(&options, &scene, &tree, &stats);
    }

    // ---- Image -----------------------------------------------------------------------------
    if (result == 0) {
        result = describe(&tree, &stats);
    }
    if (result == 0) {
        result = tree3d_draw(&scene, &tree, &image);
    }
    if (result == 0) {
        result = image_save(&image, options.output);
    }
    if (result == 0) {
        result = stats_report(&stats, options.stats);
    }
    stats_free(&stats);
    image_free(&image);
    tree3d_free(&tree);
    scene3d_free(&scene);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
