// How much a builder hands on: the elements of all nodes of its tree together, those of the root,
// of its two children and so on. That is what building costs, counted: so it is the same on every
// machine, whatever caches and other programs do to the times.
//
// Read next: case_build.h.
#ifndef BENCH_HANDED_ON_H
#define BENCH_HANDED_ON_H

#include "tree2d.h"
#include "tree3d.h"

// Count in a finished tree, which must have passed its check. An element overlaps an inner node
// where it overlaps one of its children, so the leaves' lists tell. Returns the number, or -1 after
// one message when memory runs out.
//   n_elements   of the scene
double handed_on_2d(const KdTree2D *tree, u32 n_elements);
double handed_on_3d(const KdTree3D *tree, u32 n_elements);

#endif
