// Growing a 2D kd-tree level by level: the frame of lab 02, which brings the steps.
//
// Read next: kdtree2d_build.c of lab 02, whose kdtree2d_build() hands its steps to tree2d_grow().
#ifndef COMMON_TREE2D_GROW_H
#define COMMON_TREE2D_GROW_H

#include "circle.h"
#include "tree2d.h"

// The steps of building. Contracts: kdtree2d_build.h of lab 02.
typedef struct KdSteps2D {
    int (*is_leaf)(int level, u32 n_circles, int n_failed, KdTreeLimits limits);
    void (*split_box)(BBox2D box, BBox2D *left, BBox2D *right);
    u32 (*distribute)(const Circle *h_circles, const u32 *ids, u32 n_ids, BBox2D child,
                      u32 *child_ids);
    void (*pack_leaf)(KdTree2D *tree, u32 id, const u32 *ids, u32 n_ids);
} KdSteps2D;

// Grow a tree over circles.
//   h_circles[n_circles]  centres and radii in pixels; not modified
//   bounds                the root's cell
//   tree                  out; release with tree2d_free()
// Returns 0, or a KdFault after one message on stderr.
int tree2d_grow(const KdSteps2D *steps, const Circle *h_circles, u32 n_circles, BBox2D bounds,
                KdTreeLimits limits, KdTree2D *tree);

#endif
