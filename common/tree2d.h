// The 2D kd-tree on the host: the four packed arrays of kernels/kdtree2d.h, filled by lab 02,
// copied to the device by lab 03, drawn by tree2d_draw.h.
//
// Read next: kdtree2d_build.h of lab 02.
#ifndef COMMON_TREE2D_H
#define COMMON_TREE2D_H

#include "kdtree2d.h"
#include "kdtree_limits.h"

typedef struct KdTree2D {
    NodeRel *nodes_Relations;  // [n_nodes]
    u8 *nodes_flag;            // [n_nodes], LEAF or INNER
    BBox2D *nodes_BBox;        // [n_nodes]
    u32 *mapNode2Circles;      // [n_map]
    u32 n_nodes;
    u32 n_map;
} KdTree2D;

// Release the arrays; a zeroed tree is fine.
void tree2d_free(KdTree2D *tree);

// The most entries that the lists of one tree may have together (512 MiB of ids): a tree over it is
// refused before it takes the machine's memory.
#define TREE2D_MAX_ENTRIES (1u << 27)

// The most nodes a tree may have; where there would be more, splitting does not end.
#define TREE2D_MAX_NODES (1u << 22)

// Why a builder gave up.
typedef enum KdFault {
    KD_BUILT,  // none: there is one
    KD_NO_MEMORY,
    KD_TOO_MANY_NODES,    // over the limits above
    KD_TOO_MANY_CIRCLES,  // the same, in the leaves together
    KD_LONG_CHILD,        // distribute() gave a child more circles than its parent has
    KD_LONG_LEAF,         // pack_leaf() took more room than the leaf's list needs
    N_KD_FAULTS,
} KdFault;

// Does the tree hold together, so that its ids, offsets and counts may be followed? Returns 0, or
// -1 after one message on stderr that names the first node that does not.
int tree2d_check(const KdTree2D *tree, u32 n_circles);

// How deep the tree is: levels, the root's included; 0 where there is no node. The tree must have
// passed tree2d_check(). Returns -1 after one message on stderr when memory runs out.
int tree2d_depth(const KdTree2D *tree);

#endif
