// Building the 3D kd-tree where it pays: the surface area heuristic. The tasks of lab 08; the rest
// of the builder is that of lab 06. Source: lecture 16.2, "Prinzip KD-Tree II", where it is named
// as the alternative to the middle ("Spatial Area Heuristic").
//
// A cost is what a ray that meets a node's cell is expected to take, in steps of the search.
#ifndef KDTREE3D_SAH_H
#define KDTREE3D_SAH_H

#include "sphere.h"
#include "tree3d_grow.h"

// One step of each kind: choosing a child at an inner node, and asking a sphere. Only their ratio
// matters: a node's step takes longer, as it waits for the next node to come from memory.
#define KD_COST_TRAVERSAL 1.0
#define KD_COST_TEST 0.5

// On each axis N_BINS - 1 candidate planes cut a cell into N_BINS bins of the same width.
enum { N_BINS = 32 };

// Build the 3D kd-tree over spheres, each split where the expected cost is lowest.
//   h_spheres[n_spheres]  centres and radii in scene units; not modified
//   tree                  out; release with tree3d_free()
// Returns 0, or -1 after one message on stderr, as kdtree3d_build() of lab 06.
int kdtree3d_build_sah(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree);

// The area of a box's six faces; 0 for a line or a point. max is nowhere below min.
double surface_area(BBox3D box);

// What splitting a cell costs a ray that meets it: one step at the node, and those tests of either
// child that the ray has to expect.
//   box                  the cell; its area is above 0
//   split                a plane within it or on its border
//   n_lower, n_higher    how many spheres each child would have
// Returns KD_COST_TRAVERSAL + KD_COST_TEST (A_lower n_lower + A_higher n_higher) / A_box, where A
// is surface_area(). Source: MacDonald and Booth, "Heuristics for ray tracing using space
// subdivision", The Visual Computer 6 (3), 1990.
double split_cost(BBox3D box, KdSplit split, u32 n_lower, u32 n_higher);

// Candidate plane number i of an axis: 0 < i < N_BINS.
f32 candidate_plane(BBox3D box, u32 axis, int i);

// A split and its cost.
typedef struct BestSplit {
    KdSplit split;
    double cost;  // INFINITY if no plane has a cost: then `split` means nothing
} BestSplit;

// Find the candidate plane with the lowest cost, of all three axes.
//   ids[n_ids]   the spheres that overlap the cell
//   box          the cell
// On an axis a sphere reaches from c - |r| to c + |r|, as float rounds them. It is in the lower
// child if this range begins at the plane or below, and in the higher child if it ends at the plane
// or above; so it is in both if it touches the plane. If costs are equal, x comes before y before
// z, and the lower plane before the higher. A cell without area has no cost: INFINITY.
BestSplit find_best_split(const Sphere *h_spheres, const u32 *ids, u32 n_ids, BBox3D box);

// Does a node stay a leaf? Yes, on level maxDepth or deeper, with targetElementsPerNode spheres or
// fewer, or if the best split costs no less than a leaf, which tests every sphere: KD_COST_TEST
// each.
//   level       of the node; the root's is 1
//   best_cost   of its best split
// Returns 1 or 0.
int is_leaf_by_cost(int level, u32 n_spheres, double best_cost, KdTreeLimits limits);

#endif
