// A 2D kd-tree described for people (see tree2d_report.h).
//
// Read next: tree2d_draw.c.
#include "tree2d_report.h"

#include "complain.h"
#include "output_file.h"
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

int tree2d_describe(const KdTree2D *tree, Stats *stats)
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

void tree2d_print_cells(const KdTree2D *tree, int x, int y)
{
    printf("The cells that hold pixel (%d, %d):\n", x, y);
    // Ids are breadth-first, so the cells on the way come in the order of their ids.
    for (u32 id = 0; id < tree->n_nodes; id++) {
        const BBox2D box = tree->nodes_BBox[id];
        if (x >= box.minX && x < box.maxX && y >= box.minY && y < box.maxY) {
            print_node(tree, id);
        }
    }
}

// Begin the SVG beside a picture. Returns 0, or -1 after one message.
static int svg_open(OutputFile *svg, const char *picture_path)
{
    char *path;
    const int stem_length = (int)image_stem_length(picture_path);
    if (asprintf(&path, "%.*s.svg", stem_length, picture_path) < 0) {
        complain("%s: no memory", picture_path);
        return -1;
    }
    const int result = output_file_open(svg, path);
    free(path);
    return result;
}

int tree2d_save(const Image *drawing, const Scene2D *scene, const KdTree2D *tree, const char *path)
{
    OutputFile svg;
    if (svg_open(&svg, path) != 0) {
        return -1;
    }
    // A file that cannot be written is no matter of the drawing: output_file_store() says why.
    const int no_memory = tree2d_write_svg(svg.file, scene, tree) != 0 && !ferror(svg.file);
    if (no_memory || output_file_store(&svg) != 0 || image_save(drawing, path) != 0) {
        output_file_discard(&svg);
        return -1;
    }
    return output_file_commit(&svg);
}
