// A 3D kd-tree described for people: its figures, and its nodes in words.
//
// What lab 06 shows of its tree. Read next: tree3d_draw.h, stats.h.
#ifndef COMMON_TREE3D_REPORT_H
#define COMMON_TREE3D_REPORT_H

#include "stats.h"
#include "tree3d.h"

// Add the figures tree.n_nodes, .n_leaves, .n_empty_leaves, .depth, .n_sphere_ids, .largest_leaf
// and .spheres_per_leaf, and print the nodes where they are few. The tree must have passed
// tree3d_check(). Returns 0, or -1 after one message on stderr when memory runs out.
int tree3d_describe(const KdTree3D *tree, Stats *stats);

#endif
