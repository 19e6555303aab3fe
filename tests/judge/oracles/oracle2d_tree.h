// The oracle's 2D kd-tree: what lab 02 is judged by. On the 1/16 px grid no step of oracle_tree.h
// is rounded, so there is one right tree, to the last bit.
#ifndef JUDGE_ORACLE2D_TREE_H
#define JUDGE_ORACLE2D_TREE_H

#include "oracle_tree.h"
#include "scene2d.h"
#include "tree2d.h"

// Grow the tree over scene number k and pack it; release it with tree2d_free(). Returns 0, or -1
// after one message.
int oracle2d_tree(const Scene2D *scene, u32 k, KdTreeLimits limits, Growth *growth, KdTree2D *tree);

// The root's cell: the smallest box of whole numbers whose half-open inside holds every circle.
BBox2D oracle2d_root(const Scene2D *scene);

// The two halves of a cell, the one with the lower coordinates first. Returns the axis.
u32 oracle2d_halves(BBox2D box, BBox2D halves[2]);

// How many circles overlap a cell.
u32 oracle2d_n_overlapping(const Scene2D *scene, BBox2D box);

// A cell of oracle_tree.h, and back.
BBox2D oracle2d_box(BBox3D cell);
BBox3D oracle2d_cell(BBox2D box);

#endif
