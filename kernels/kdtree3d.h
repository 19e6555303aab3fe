// The packed 3D kd-tree: nodes with a split plane and no box, and the ids of the spheres in each
// leaf. Built on the host (lab 06), searched by the kernel (lab 07).
//
//   nodes[n_nodes]            KdNode3  in breadth-first order from 0, the root, without gaps
//   sphere_ids[n_sphere_ids]  u32      the leaves' ids: one range a leaf, in the leaves' order
//   bounds                    BBox3D   the scene's box, the only one that is kept
//
// Lecture: slide "Node im 3D-KD Tree". Flow: scene -> BUFFERS -> KERNEL -> image. Read next:
// kdtree3d_build.h of lab 06, todo.h.
#ifndef KERNELS_KDTREE3D_H
#define KERNELS_KDTREE3D_H

#include "layout.h"

enum {
    KD_LEAF = 3,  // split_axis of a node without children; 0, 1 and 2 stand for x, y and z
};

// How many nodes can wait at once while a ray is traced (todo.h). The kernel never tests whether
// there is room: the builder refuses a tree in which more could wait (task fits_todo of lab 06).
#define TODO_SIZE 40

typedef struct KdNode3 {
    /*  0 */ f32 split_pos;   // inner node: the plane's coordinate on split_axis, scene units
    /*  4 */ u32 split_axis;  // 0 = x, 1 = y, 2 = z; KD_LEAF marks a leaf
    /*  8 */ u32 first;       // inner node: id of the child with the lower coordinates; the other
                              // child is first + 1. Leaf: where its ids start in sphere_ids
    /* 12 */ u32 n_spheres;   // leaf: how many ids there are; inner node: 0
} KdNode3;
LAYOUT_ASSERT(KdNode3, 16);

// A box with sides along the axes; its border belongs to it. Entry 0 is x, 1 is y, 2 is z.
typedef struct BBox3D {
    /*  0 */ f32 min[3];
    /* 12 */ f32 max[3];
} BBox3D;
LAYOUT_ASSERT(BBox3D, 24);

#endif
