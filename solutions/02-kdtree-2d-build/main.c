// Lab 02: build the kd-tree over the circles, print it and draw it. Nothing to fill in here; read
// it from top to bottom once, then go to kdtree2d_build.c.
//
// Flow: scene -> BUFFERS (the tree's four arrays) -> kernel (lab 03) -> image -> comparison.
#include "complain.h"
#include "image.h"
#include "kdtree2d_build.h"
#include "options.h"
#include "output_file.h"
#include "scene2d.h"
#include "stats.h"
#include "tree2d_draw.h"

#include <stdio.h>
#include <stdlib.h>

// Trees of up to this many nodes are printed node by node.
enum { MAX_PRINTED_NODES = 63 };

// One line for a node: its cell, and its children or its circles.
static void print_node(const KdTree2D *tree, u32 id)
{
    const NodeRel node = tree->nodes_Relations[id];
    const BBox2D box = tree->nodes_BBox[id];
    printf("  node %3u  x [%g, %g]  y [%g, %g]  ", id, box.minX, box.maxX, box.minY, box.maxY);
    if (tree->nodes_flag[id] != LEAF) {
        printf("children %u and %u\n", node.lChild, node.rChild);
        return;
    }
    const u32 *list = tree->mapNode2Circles + node.circleMapOffset;
    printf("leaf, %u %s:", list[0], list[0] == 1 ? "circle" : "circles");
    for (u32 i = 1; i <= list[0]; i++) {
        printf(" %u", list[i]);
    }
    printf("\n");
}

// The lecture's worked example: which cells hold pixel (7, 7), from the root to the leaf? Ids are
// breadth-first, so the cells on the way come in the order of their ids.
static int print_worked_example(void)
{
    const int x = 7, y = 7;
    const KdTreeLimits limits = {.maxDepth = 4, .targetElementsPerNode = 1};
    Scene2D scene = {0};
    KdTree2D tree = {0};
    if (scene2d_open("example", 0, 0, &scene) != 0) {
        return -1;
    }
    if (kdtree2d_build(scene.circles, (u32)scene.n_circles, limits, &tree) != 0 ||
        tree2d_check(&tree, (u32)scene.n_circles) != 0) {
        tree2d_free(&tree);
        scene2d_free(&scene);
        return -1;
    }
    printf("Worked example: circles A to E are 0 to 4, maxDepth 4, targetElementsPerNode 1.\n");
    printf("The cells that hold pixel (%d, %d):\n", x, y);
    for (u32 id = 0; id < tree.n_nodes; id++) {
        const BBox2D box = tree.nodes_BBox[id];
        if (x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY) {
            print_node(&tree, id);
        }
    }
    tree2d_free(&tree);
    scene2d_free(&scene);
    return 0;
}

// The tree's figures, and its nodes where they are few. Returns 0, or -1 after one message.
static int describe(const KdTree2D *tree, Stats *stats)
{
    const int depth = tree2d_depth(tree);
    if (depth < 0) {
        return -1;
    }
    u32 n_leaves = 0, largest_leaf = 0;
    for (u32 id = 0; id < tree->n_nodes; id++) {
        if (tree->nodes_flag[id] == LEAF) {
            const u32 count = tree->mapNode2Circles[tree->nodes_Relations[id].circleMapOffset];
            largest_leaf = count > largest_leaf ? count : largest_leaf;
            n_leaves++;
        }
    }
    stats_integer(stats, "tree.n_nodes", tree->n_nodes);
    stats_integer(stats, "tree.n_leaves", n_leaves);
    stats_integer(stats, "tree.depth", depth);
    stats_integer(stats, "tree.n_map", tree->n_map);
    stats_integer(stats, "tree.largest_leaf", largest_leaf);
    stats_number(stats, "tree.circles_per_leaf", (double)(tree->n_map - n_leaves) / n_leaves);
    if (tree->n_nodes <= MAX_PRINTED_NODES) {
        printf("The tree:\n");
        for (u32 id = 0; id < tree->n_nodes; id++) {
            print_node(tree, id);
        }
    }
    return 0;
}

// Write the drawing, and beside it the same as SVG, "tree.png" and "tree.svg": both or neither.
static int save_drawing(const char *picture_path, const Image *image, const Scene2D *scene,
                        const KdTree2D *tree)
{
    char *path = NULL;
    OutputFile output = {0};
    const int stem_length = (int)image_stem_length(picture_path);
    if (asprintf(&path, "%.*s.svg", stem_length, picture_path) < 0) {
        complain("%s: no memory", picture_path);
        return -1;
    }
    int result = output_file_open(&output, path);
    free(path);
    // A file that cannot be written is no matter of the drawing: output_file_store() says why.
    if (result == 0 && tree2d_write_svg(output.file, scene, tree) != 0 && !ferror(output.file)) {
        result = -1;
    }
    if (result == 0) {
        result = output_file_store(&output);
    }
    if (result == 0) {
        result = image_save(image, picture_path);
    }
    if (result == 0) {
        return output_file_commit(&output);
    }
    output_file_discard(&output);
    return -1;
}

// Build as often as --frames says and note how long it takes; keeps the last tree. Returns 0, or -1
// after one message.
static int build(const Options *options, const Scene2D *scene, KdTree2D *tree, Stats *stats)
{
    const KdTreeLimits limits = {options->max_depth, options->leaf_size};
    double *milliseconds = stats_times_create(options->n_frames);
    int result = 0;
    for (int i = 0; result == 0 && i < options->n_frames; i++) {
        tree2d_free(tree);
        const double start = stats_clock_ms();
        result = kdtree2d_build(scene->circles, (u32)scene->n_circles, limits, tree);
        milliseconds[i] = stats_clock_ms() - start;
    }
    if (result == 0) {
        result = tree2d_check(tree, (u32)scene->n_circles);
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
    switch (options_parse(argc, argv, LAB_NAME, "Builds the kd-tree over circles and draws it.",
                          OPTIONS_SCENE | OPTIONS_TREE, &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }

    // ---- Scene -----------------------------------------------------------------------------
    Scene2D scene = {0};
    KdTree2D tree = {0};
    Image image = {0};
    Stats stats = {0};
    int result = scene2d_open(options.scene, options.width, options.height, &scene);
    if (result == 0) {
        stats_text(&stats, "lab", LAB_NAME);
        stats_text(&stats, "scene", options.scene);
        stats_integer(&stats, "n_circles", scene.n_circles);
        stats_integer(&stats, "width", scene.width);
        stats_integer(&stats, "height", scene.height);
        stats_integer(&stats, "max_depth", options.max_depth);
        stats_integer(&stats, "leaf_size", options.leaf_size);
        result = print_worked_example();
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
        result = tree2d_draw(&scene, &tree, &image);
    }
    if (result == 0) {
        result = save_drawing(options.output, &image, &scene, &tree);
    }
    if (result == 0) {
        result = stats_report(&stats, options.stats);
    }
    stats_free(&stats);
    image_free(&image);
    tree2d_free(&tree);
    scene2d_free(&scene);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
