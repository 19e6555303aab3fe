// A 2D kd-tree described for people: its figures, its nodes in words, its drawing in files.
//
// What lab 02 shows of its tree. Read next: tree2d_draw.h, stats.h.
#ifndef COMMON_TREE2D_REPORT_H
#define COMMON_TREE2D_REPORT_H

#include "image.h"
#include "scene2d.h"
#include "stats.h"
#include "tree2d.h"

// Add the figures tree.n_nodes, .n_leaves, .depth, .n_map, .largest_leaf and .circles_per_leaf, and
// print the nodes where they are few. The tree must have passed tree2d_check(). Returns 0, or -1
// after one message on stderr when memory runs out.
int tree2d_describe(const KdTree2D *tree, Stats *stats);

// Print the cells that hold the pixel (x, y), from the root to the leaf. The tree must have passed
// tree2d_check().
void tree2d_print_cells(const KdTree2D *tree, int x, int y);

// Write the drawing (tree2d_draw()) to `path`, and beside it the same as SVG, "tree.png" and
// "tree.svg": both or neither. Returns 0, or -1 after one message on stderr.
int tree2d_save(const Image *drawing, const Scene2D *scene, const KdTree2D *tree, const char *path);

#endif
