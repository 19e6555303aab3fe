// Building the 3D kd-tree: from spheres to nodes without boxes. What lab 02 has taught is given;
// the rest are the tasks of lab 06. Lab 07 searches the tree.
// Source of all of it: lecture, slides "Prinzip KD-Tree II" and "Node im 3D-KD Tree".
#ifndef KDTREE3D_BUILD_H
#define KDTREE3D_BUILD_H

#include "tree3d_grow.h"

// Build the 3D kd-tree over spheres.
//   h_spheres[n_spheres]  centres and radii in scene units; not modified
//   tree                  out; release with tree3d_free()
// Returns 0, or -1 after one message on stderr: no memory, a tree over the limits of tree3d.h, or
// one whose search would need more than TODO_SIZE places.
int kdtree3d_build(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree);

// The root's cell: the smallest box that holds every sphere whole, up to float's rounding. All
// zeros if there is none. A negative radius counts as its absolute value.
BBox3D spheres_bounds(const Sphere *h_spheres, u32 n_spheres);

// Where to split a cell: in the middle of its longest side. If sides are equal, x comes before y,
// and y before z.
KdSplit choose_split(BBox3D box);

// Does a sphere overlap a cell? Both include their boundaries and their insides. The answer is
// exact: near a corner the cube around the sphere may overlap the cell, and the sphere not.
// Returns 1 or 0.
int sphere_overlaps_box(Sphere sphere, BBox3D box);

// Pick from a node's spheres those that overlap one child's cell.
//   ids[n_ids]   the node's spheres, ascending
//   child_ids    out: room for n_ids; the child's spheres, ascending
// Returns how many there are.
u32 distribute_spheres(const Sphere *h_spheres, const u32 *ids, u32 n_ids, BBox3D child,
                       u32 *child_ids);

// Make node `id` a leaf and append its spheres to tree->sphere_ids, which has room for them.
//   ids[n_ids]   the leaf's spheres, ascending
// Sets all of the node but split_pos, writes the ids in this order, and moves tree->n_sphere_ids
// behind them. Nothing else in the tree changes.
void pack_leaf_range(KdTree3D *tree, u32 id, const u32 *ids, u32 n_ids);

// May a node on this level (the root's is 1) be split, so that no search overflows the todo stack?
// There a search (lab 07) keeps the nodes that it still has to visit: each inner node on the way
// down may leave one child waiting, and there are TODO_SIZE places. Returns 1 or 0.
int fits_todo(int level);

#endif
