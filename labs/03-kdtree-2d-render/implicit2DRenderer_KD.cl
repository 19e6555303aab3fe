// Lab 03: implicit 2D rendering with the kd-tree: a pixel tests only the circles of its own cell.
//
// Flow: scene -> buffers (the tree of lab 02) -> KERNEL -> image. Started by main.c.
#include "kdtree2d.h"
#include "overlaps_N_Nearer.cl"
#include "work.h"

// The child of an inner node whose half-open cell, minX <= x < maxX and minY <= y < maxY, contains
// the pixel (x, y). If the node's own cell contains it, exactly one child's cell does. For a pixel
// outside the root it may be either child: no circle covers it.
//   id     the inner node
//   work   what this pixel has cost so far; the call is counted
// Returns the child's id. Source: slide "Finde enthaltende Child Node".
uint getContainingChild(int x, int y, uint id, global const NodeRel *nodes_Relations,
                        global const BBox2D *nodes_BBox, Work *work)
{
    count_node(work);
    // TASK getContainingChild: look at the left child's cell; if the pixel is not there, it is
    // in the right child's.
    (void)x, (void)y, (void)nodes_BBox;
    return nodes_Relations[id].lChild;
    // END getContainingChild
}

// Draw the circles, one work-item per pixel; the same picture as implicit2DRenderer, faster.
//   circles            the scene; the tree's circle ids count from its start
//   nodes_...          the packed tree (kdtree2d.h); node 0 is the root
//   mapNode2Circles    at a leaf's circleMapOffset a count, then that many circle ids, ascending
//   width, height      the picture, pixels; work-items outside it write nothing
//   image              RGBA float, at least width x height; row 0 is the top row
//   d_work             what each pixel cost; NULL if nothing is counted
// A pixel that no circle covers is (0, 0, 0, 0). Source: slides "Suche in KD-Tree" and "Kernel".
kernel void implicit2DRenderer_KD(global const Circle *circles,
                                  global const NodeRel *nodes_Relations,
                                  global const uchar *nodes_flag, global const BBox2D *nodes_BBox,
                                  global const uint *mapNode2Circles, int width, int height,
                                  write_only image2d_t image, global Work *d_work)
{
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    // Spare work-items are outside the picture.
    if (x >= width || y >= height) {
        return;
    }

    Work work = {0, 0, 0, 0};
    uint id = 0;
    // TASK descent: from the root, id = 0, go to the child with the pixel until id is a leaf.
    (void)id, (void)nodes_flag, (void)nodes_BBox;
    // END descent

    float4 color = (float4)(0.0f);
    // TASK leaf_loop: test the circles of leaf `id`, in the order of its list, and keep the colour
    // of the nearest one that covers the pixel.
    (void)circles, (void)nodes_Relations, (void)mapNode2Circles;
    // END leaf_loop
    write_imagef(image, (int2)(x, y), color);
    work_save(work, x, y, width, d_work);
}
