// When a node of a kd-tree stays a leaf; 2D and 3D alike. "Elements" are circles or spheres.
//
// Read next: tree2d.h, tree3d.h.
#ifndef COMMON_KDTREE_LIMITS_H
#define COMMON_KDTREE_LIMITS_H

#include "layout.h"

typedef struct KdTreeLimits {
    int maxDepth;               // levels, the root's included: a node on level maxDepth is a leaf
    int targetElementsPerNode;  // a node with this many circles or spheres, or fewer, is a leaf
} KdTreeLimits;

// A node with this many failed splits above it is a leaf. Elements that lie one upon another are
// parted by no split; without this limit each level would list all of them twice as often. One
// split on each axis may fail and the next still help, as where a scene is symmetrical: so one more
// than there are axes in 3D.
#define MAX_FAILED_SPLITS 4

// Has a split failed: have both children kept nearly all of their parent's elements? So it is where
// their lists are together at least 9/5 as long as its own; 10/5 is both keep all.
static inline int split_failed(u32 n_parent, u32 n_left, u32 n_right)
{
    return 5 * ((u64)n_left + n_right) >= 9 * (u64)n_parent;
}

#endif
