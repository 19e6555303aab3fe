// The 3D kd-tree on the host: the arrays of kernels/kdtree3d.h, filled by lab 06, copied to the
// device by lab 07.
//
// Read next: kdtree3d_build.h of lab 06.
#ifndef COMMON_TREE3D_H
#define COMMON_TREE3D_H

#include "kdtree3d.h"
#include "kdtree_limits.h"

typedef struct KdTree3D {
    BBox3D bounds;    // of the scene: the root's cell
    KdNode3 *nodes;   // [n_nodes]
    u32 *sphere_ids;  // [n_sphere_ids], the leaves' ranges one after the other
    u32 n_nodes;
    u32 n_sphere_ids;
} KdTree3D;

// Release the arrays; a zeroed tree is fine.
void tree3d_free(KdTree3D *tree);

// The most ids that the leaves of one tree may hold together (512 MiB), and the most nodes
// (256 MiB): a tree over them is refused before it takes the machine's memory.
#define TREE3D_MAX_SPHERE_IDS (1u << 27)
#define TREE3D_MAX_NODES (1u << 24)

// Does the tree hold together, so that its ids and ranges may be followed, by a kernel too:
// children and ranges inside their arrays, children behind their parents, and no deeper than the
// todo stack allows? Returns 0, or -1 after one message on stderr that names the first node that
// does not.
int tree3d_check(const KdTree3D *tree, u32 n_spheres);

// A tree in figures.
typedef struct TreeFigures3D {
    int depth;  // levels, the root's included
    u32 n_leaves;
    u32 n_empty;       // leaves without a sphere
    u32 largest_leaf;  // spheres
} TreeFigures3D;

// Count. The tree must have passed tree3d_check(). Returns 0, or -1 after one message on stderr
// when memory runs out.
int tree3d_figures(const KdTree3D *tree, TreeFigures3D *figures);

// A box, one float wider on each side. Bounds are rounded, and a sphere may reach up to half a step
// out of them (at 100 000 a float's steps are 1/128): the wider box holds it whole.
BBox3D box_widened(BBox3D box);

// The limits that fit a scene of this many spheres where the user gives none (0).
//   max_depth, leaf_size   as the user gave them, 0 where not
KdTreeLimits tree3d_limits(int max_depth, int leaf_size, u32 n_spheres);

#endif
