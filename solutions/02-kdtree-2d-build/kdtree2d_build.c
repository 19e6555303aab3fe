// Lab 02: building the 2D kd-tree.
//
// Flow: scene -> BUFFERS (this file fills the tree's four) -> kernel -> image. Called by main.c
// here and in lab 03. Read the contracts in kdtree2d_build.h first, then kdtree2d_build() at the
// end, which passes your functions to tree2d_grow(): that shows how they go together. Nothing here
// needs stdio.h and stdlib.h: they are for what you print while you look for a mistake.
#include "kdtree2d_build.h"

#include "tree2d_grow.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

BBox2D scene_bounds(const Circle *h_circles, u32 n_circles)
{
    if (n_circles == 0) {
        return (BBox2D){0};
    }
    BBox2D box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (u32 i = 0; i < n_circles; i++) {
        const Circle c = h_circles[i];
        box.minX = fminf(box.minX, c.x - c.radius);
        box.maxX = fmaxf(box.maxX, c.x + c.radius);
        box.minY = fminf(box.minY, c.y - c.radius);
        box.maxY = fmaxf(box.maxY, c.y + c.radius);
    }
    // The last covered pixel of a row is at most floor(maxX), and maxX itself is outside a cell.
    return (BBox2D){floorf(box.minX), floorf(box.maxX) + 1, floorf(box.minY), floorf(box.maxY) + 1};
}

int is_leaf(int level, u32 n_circles, int n_failed, KdTreeLimits limits)
{
    // TASK is_leaf: stop on level maxDepth, at targetElementsPerNode circles or fewer, or after
    // MAX_FAILED_SPLITS failed splits.
    //> (void)level, (void)n_circles, (void)n_failed, (void)limits;
    //> return 1;
    return level >= limits.maxDepth || n_circles <= (u32)limits.targetElementsPerNode ||
           n_failed >= MAX_FAILED_SPLITS;
    // END is_leaf
}

void split_box(BBox2D box, BBox2D *left, BBox2D *right)
{
    *left = box;
    *right = box;
    // TASK split_box: both start as the whole cell; in each of them move the one border that the
    // split moves.
    //> // (your code)
    const float width = box.maxX - box.minX;
    const float height = box.maxY - box.minY;
    if (width >= height) {
        left->maxX = right->minX = box.minX + width / 2;
    } else {
        left->maxY = right->minY = box.minY + height / 2;
    }
    // END split_box
}

int circle_overlaps_box(Circle circle, BBox2D box)
{
    // TASK circle_overlaps_box: find the cell's point nearest to the centre, then test whether
    // the circle covers it. In double every step is exact for the scenes of this course.
    //> (void)circle, (void)box;
    //> return 0;
    const double nearest_x = fmin(fmax(circle.x, box.minX), box.maxX);
    const double nearest_y = fmin(fmax(circle.y, box.minY), box.maxY);
    const double dx = circle.x - nearest_x;
    const double dy = circle.y - nearest_y;
    return dx * dx + dy * dy <= (double)circle.radius * circle.radius;
    // END circle_overlaps_box
}

u32 distribute(const Circle *h_circles, const u32 *ids, u32 n_ids, BBox2D child, u32 *child_ids)
{
    // TASK distribute: call circle_overlaps_box() for each of the node's circles. A circle that
    // overlaps both children goes to both: this function is called once for each.
    //> (void)h_circles, (void)ids, (void)n_ids, (void)child, (void)child_ids;
    //> return 0;
    u32 n_child_ids = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (circle_overlaps_box(h_circles[ids[i]], child)) {
            child_ids[n_child_ids++] = ids[i];
        }
    }
    return n_child_ids;
    // END distribute
}

void pack_leaf(KdTree2D *tree, u32 id, const u32 *ids, u32 n_ids)
{
    // TASK pack_leaf: circleMapOffset is the position of the count, the 2 in {..., 2, 90, 90000}.
    //> (void)tree, (void)id, (void)ids, (void)n_ids;
    tree->nodes_flag[id] = LEAF;
    tree->nodes_Relations[id].circleMapOffset = tree->n_map;
    tree->mapNode2Circles[tree->n_map++] = n_ids;
    for (u32 i = 0; i < n_ids; i++) {
        tree->mapNode2Circles[tree->n_map++] = ids[i];
    }
    // END pack_leaf
}

int kdtree2d_build(const Circle *h_circles, u32 n_circles, KdTreeLimits limits, KdTree2D *tree)
{
    const KdSteps2D steps = {is_leaf, split_box, distribute, pack_leaf};
    return tree2d_grow(&steps, h_circles, n_circles, scene_bounds(h_circles, n_circles), limits,
                       tree);
}
