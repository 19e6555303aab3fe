// What the kernel of Part A reads: a kd-tree over circles whose planes lie between tiles, and each
// leaf's circles, nearest first. For host and device.
//
// Flow: scene -> BUFFERS -> KERNEL -> image. Written by circle_tree.c. Read next: circle_tile.cl.
#ifndef KERNELS_CIRCLE_TILES_H
#define KERNELS_CIRCLE_TILES_H

#include "kdtree3d.h"
#include "layout.h"

// Planes stand at multiples of this, so that a tile with sides of this many pixels, or a smaller
// one that its side divides into, lies in one leaf whole.
#define CIRCLE_TILE_SIDE 16

// As KdNode3, in two dimensions: without boxes, node 0 is the root, a leaf has split_axis KD_LEAF.
typedef struct TileNode {
    /*  0 */ i32 split_pos;   // inner node: the first pixel of the child with the higher ones
    /*  4 */ u32 split_axis;  // 0 = x, 1 = y
    /*  8 */ u32 first;       // inner node: id of the child with the lower coordinates; the other
                              // child is first + 1. Leaf: where its circles start
    /* 12 */ u32 n_circles;   // leaf: how many there are
} TileNode;
LAYOUT_ASSERT(TileNode, 16);

// What a pixel has to know of a circle; its depth is its place in the list.
typedef struct TileCircle {
    /*  0 */ f32 x;  // centre, pixels
    /*  4 */ f32 y;
    /*  8 */ f32 radius_squared;  // the boundary belongs to the circle
    /* 12 */ u32 color;           // RGBA, a byte each, red lowest
} TileCircle;
LAYOUT_ASSERT(TileCircle, 16);

#endif
