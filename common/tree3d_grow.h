// Growing a 3D kd-tree level by level, whatever rule splits its nodes: the frame of labs 06 and 08,
// which bring the steps.
//
// Read next: kdtree3d_build.c of lab 06, whose kdtree3d_build() hands its steps to tree3d_grow().
#ifndef COMMON_TREE3D_GROW_H
#define COMMON_TREE3D_GROW_H

#include "sphere.h"
#include "tree3d.h"

// A plane at right angles to an axis.
typedef struct KdSplit {
    u32 axis;  // 0 = x, 1 = y, 2 = z
    f32 pos;   // the plane's coordinate on it
} KdSplit;

// An open node: one that still has to become an inner node or a leaf. Its cell is known only while
// the tree grows: the packed tree has no boxes.
typedef struct KdOpenNode {
    BBox3D box;
    const u32 *ids;  // [n_ids] of the spheres that overlap it, ascending
    u32 n_ids;
    int level;     // the root's is 1
    int n_failed;  // splits above it that failed: see split_failed()
} KdOpenNode;

// Shall the node be split, and where?
//   rules   of the lab: KdSteps.rules
//   split   out, where it shall
// Returns 1, or 0 when it stays a leaf.
typedef int ChooseSplit(const void *rules, const KdOpenNode *node, KdSplit *split);

// In a loop over a node's spheres, at number i: ask the memory for one that is N_AHEAD turns away.
// They lie far apart, and without this the loop waits for nearly each of them. Changes nothing.
enum { N_AHEAD = 16 };
static inline void fetch_ahead(const Sphere *h_spheres, const u32 *ids, u32 n_ids, u32 i)
{
    __builtin_prefetch(&h_spheres[ids[i + N_AHEAD < n_ids ? i + N_AHEAD : i]]);
}

// The steps of building, as a lab has them. Contracts: kdtree3d_build.h of lab 06. Where the frame
// is compiled with -fopenmp, choose_split and distribute_spheres are called by several threads at
// once.
typedef struct KdSteps {
    const char *name;  // of the builder, for messages
    ChooseSplit *choose_split;
    const void *rules;  // for choose_split
    u32 (*distribute_spheres)(const Sphere *h_spheres, const u32 *ids, u32 n_ids, BBox3D child,
                              u32 *child_ids);
    void (*pack_leaf_range)(KdTree3D *tree, u32 id, const u32 *ids, u32 n_ids);
    int (*fits_todo)(int level);
} KdSteps;

// Grow a tree over spheres: on one thread, as labs and grader do; where this is compiled with
// -fopenmp, on as many as OpenMP is told (omp_set_num_threads()). The tree is the same to the bit.
//   h_spheres[n_spheres]  centres and radii in scene units; not modified
//   bounds                the root's cell
//   tree                  out; release with tree3d_free()
// Returns 0, or -1 after one message on stderr: no memory, a tree over the limits of tree3d.h, or
// one that steps->fits_todo refuses.
int tree3d_grow(const KdSteps *steps, const Sphere *h_spheres, u32 n_spheres, BBox3D bounds,
                KdTree3D *tree);

#endif
