// The oracle's 2D kd-tree: what lab 02 is judged by. It shares no code with the labs.
//
// Nothing is handed down from parent to child: every cell asks every circle, in double precision.
// On the 1/16 px grid no step is rounded, so there is one right tree, to the last bit.
#ifndef GRADER_ORACLE2D_TREE_H
#define GRADER_ORACLE2D_TREE_H

#include "scene2d.h"
#include "tree2d.h"

// Grow the tree over a scene; release it with tree2d_free(). Returns 0, or -1 after one message.
int oracle2d_tree(const Scene2D *scene, KdTreeLimits limits, KdTree2D *tree);

// The root's cell: the smallest box of whole numbers whose half-open inside holds every circle.
BBox2D oracle2d_root(const Scene2D *scene);

// The two halves of a cell, the one with the lower coordinates first.
void oracle2d_halves(BBox2D box, BBox2D halves[2]);

// Does a node stay a leaf?
//   n_failed   how many splits above it failed
int oracle2d_is_leaf(int level, u32 n_circles, int n_failed, KdTreeLimits limits);

// Do both halves of a cell keep nearly all of its circles?
int oracle2d_split_fails(u32 n_circles, u32 n_lower, u32 n_higher);

// How many circles overlap a cell.
u32 oracle2d_n_overlapping(const Scene2D *scene, BBox2D box);

#endif
