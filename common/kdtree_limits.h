// When a node of a kd-tree stays a leaf; 2D and 3D alike.
//
// Flow: scene -> BUFFERS -> kernel -> image -> comparison. Read next: tree2d.h, tree3d.h.
#ifndef COMMON_KDTREE_LIMITS_H
#define COMMON_KDTREE_LIMITS_H

typedef struct KdTreeLimits {
    int maxDepth;               // levels, the root's included: a node on level maxDepth is a leaf
    int targetElementsPerNode;  // a node with this many circles or spheres, or fewer, is a leaf
} KdTreeLimits;

#endif
