// A tree as lab 08 looks at it: what a ray is expected to cost in it, and its figures. Given.
#ifndef TREE_REPORT_H
#define TREE_REPORT_H

#include "stats.h"
#include "tree3d.h"

// What a ray that meets the scene's box is expected to cost in the tree, if it ends at nothing: a
// step at each inner node and the tests of each leaf, each with the probability that the ray meets
// the node's cell. The tree must have passed tree3d_check(). Returns the cost in the units of
// kdtree3d_sah.h, or -1 after one message on stderr when memory runs out.
double tree_cost(const KdTree3D *tree);

// Add the figures NAME.cost, .build_ms, .n_nodes, .depth, .largest_leaf and .n_sphere_ids. The tree
// must have passed tree3d_check().
//   build_ms   how long building it took
// Returns 0, or -1 after one message on stderr when memory runs out.
int tree_report(const KdTree3D *tree, const char *name, double build_ms, Stats *stats);

#endif
