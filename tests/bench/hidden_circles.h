// The tree of lab 10's Part A with the circles that nothing can be seen of in the leaves' lists,
// which circle_tree_build() drops.
//
// Used by trick_case.c.
#ifndef BENCH_HIDDEN_CIRCLES_H
#define BENCH_HIDDEN_CIRCLES_H

#include "circle_tree.h"

// The same nodes, and in each leaf's list every circle that overlaps it, nearest first.
//   side      of the picture, pixels: a square of whole tiles
//   circles   all of the scene: a tree of one leaf
//   hidden    out; release with circle_tree_free()
// Returns 0, or -1 after one message when memory runs out.
int hidden_circles_add(const CircleTree *tree, int side, const CircleTree *circles,
                       CircleTree *hidden);

#endif
