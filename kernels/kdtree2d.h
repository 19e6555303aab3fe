// The packed 2D kd-tree: four arrays that the host builds (lab 02) and the kernel searches (lab
// 03). Flow: scene -> BUFFERS -> KERNEL -> image.
//
//   nodes_Relations[n_nodes]   NodeRel   who is whose child, and where a leaf's list starts
//   nodes_flag[n_nodes]        u8        LEAF or INNER
//   nodes_BBox[n_nodes]        BBox2D    the cell of each node
//   mapNode2Circles[n_map]     u32       for each leaf a count and as many circle ids, ascending
//
// Node ids count in breadth-first order from 0, the root, without gaps: a node's id is its position
// in the arrays. Source: slide "Implementation: Daten". Read next: kdtree2d_build.h of lab 02.
#ifndef KERNELS_KDTREE2D_H
#define KERNELS_KDTREE2D_H

#include "layout.h"

enum {
    LEAF = 0,   // nodes_flag of a node without children
    INNER = 1,  // nodes_flag of a node with two children
};

// nodes_flag tells leaf from inner node, as in the lecture. A leaf's lChild and rChild mean
// nothing (the builder leaves 0 there), nor does an inner node's circleMapOffset, which is 0.
typedef struct NodeRel {
    /*  0 */ u32 id;               // the node's own position in the arrays
    /*  4 */ u32 lChild;           // the child with the lower coordinates
    /*  8 */ u32 rChild;           // the child with the higher coordinates
    /* 12 */ u32 circleMapOffset;  // leaf: the position of its count in mapNode2Circles
} NodeRel;
LAYOUT_ASSERT(NodeRel, 16);

// A cell. For pixels it is half-open, minX <= x < maxX: every pixel of the root lies in one leaf.
typedef struct BBox2D {
    /*  0 */ f32 minX;
    /*  4 */ f32 maxX;
    /*  8 */ f32 minY;
    /* 12 */ f32 maxY;
} BBox2D;
LAYOUT_ASSERT(BBox2D, 16);

#endif
