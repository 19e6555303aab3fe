// The kd-tree of Part A on the host: planes between tiles, lists by depth. Given; lab 02 has the
// same steps.
#ifndef CIRCLE_TREE_H
#define CIRCLE_TREE_H

#include "circle_tiles.h"
#include "kdtree_limits.h"
#include "scene2d.h"

typedef struct CircleTree {
    TileNode *nodes;           // [n_nodes]
    TileCircle *leaf_circles;  // [n_leaf_circles]: one range a leaf, nearest first
    u32 n_nodes;
    u32 n_leaf_circles;
} CircleTree;

// Build the tree over a scene's picture, rounded up to whole tiles.
//   tree   out; release with circle_tree_free()
// A circle that nothing of can be seen in a leaf, as a nearer one covers the leaf whole, is not in
// its list. Returns 0, or -1 after one message on stderr when memory runs out.
int circle_tree_build(const Scene2D *scene, KdTreeLimits limits, CircleTree *tree);

// Release the arrays; a zeroed tree is fine.
void circle_tree_free(CircleTree *tree);

#endif
