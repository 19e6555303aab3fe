// Building the 2D kd-tree: from circles to the four packed arrays. Tasks of lab 02; lab 03 searches
// the result. Source: slides "Prinzip KD-Tree I, II", "Implementation: Daten" and "Datenlayout".
#ifndef KDTREE2D_BUILD_H
#define KDTREE2D_BUILD_H

#include "circle.h"
#include "tree2d.h"

// Build the 2D kd-tree over circles.
//   h_circles[n_circles]  centres and radii in pixels; not modified
//   tree                  out; release with tree2d_free()
// Returns 0, or after one message on stderr a KdFault of tree2d.h.
int kdtree2d_build(const Circle *h_circles, u32 n_circles, KdTreeLimits limits, KdTree2D *tree);

// The root's cell: the smallest box with integer corners whose half-open inside,
// minX <= x < maxX, holds every circle whole. All zeros when there is no circle.
BBox2D scene_bounds(const Circle *h_circles, u32 n_circles);

// Does a node stay a leaf?
//   level      1 for the root, one more for each generation
//   n_circles  how many circles overlap its cell
//   n_failed   how many of the splits on the way down to it failed: see split_failed()
// Returns 1 for a leaf, 0 for a node to be split.
int is_leaf(int level, u32 n_circles, int n_failed, KdTreeLimits limits);

// Halve a cell across its longer side; across x if both sides are equal.
//   left, right   out: the half with the lower coordinates, and the one with the higher
void split_box(BBox2D box, BBox2D *left, BBox2D *right);

// Does a circle overlap a cell? Both include their boundaries, and the test is exact: near a corner
// the circle's bounding square may overlap the cell although the circle does not. Returns 1 or 0.
int circle_overlaps_box(Circle circle, BBox2D box);

// Pick from a node's circles those that overlap one child's cell.
//   ids[n_ids]   the node's circles, ascending
//   child_ids    out: room for n_ids; the child's circles, ascending
// Returns how many there are.
u32 distribute(const Circle *h_circles, const u32 *ids, u32 n_ids, BBox2D child, u32 *child_ids);

// Make node `id` a leaf and append its list to tree->mapNode2Circles, which has room for it.
//   ids[n_ids]   the leaf's circles, ascending
// Sets the node's flag and circleMapOffset, writes the count and the ids in this order, and moves
// tree->n_map behind them. Nothing else in the tree changes.
void pack_leaf(KdTree2D *tree, u32 id, const u32 *ids, u32 n_ids);

#endif
