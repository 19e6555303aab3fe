// Reading a student's tree without trusting it, and walking down it: every id and range is checked
// before it is used. For tree3d_judge.c and tree3d_judge_packing.c.
#ifndef JUDGE_TREE3D_WALK_H
#define JUDGE_TREE3D_WALK_H

#include "tree3d_judge.h"

int is_leaf_node(const KdTree3D *tree, u32 id);

// Can one go on from an inner node: an axis, and both children there, behind it?
int has_children(const KdTree3D *tree, u32 id);

// The ids of a leaf, or NULL when its range leads out of the array.
const u32 *leaf_ids(const KdTree3D *tree, u32 id);

// What is wrong with a leaf whose range does.
Diagnosis bad_range(const TreeScene3D *scene, const KdTree3D *own, u32 id);

// Does a leaf's list ascend? Its range is in the array.
Diagnosis judge_order(const TreeScene3D *scene, const KdTree3D *own, u32 id);

// What the nodes do not hold: where each node's cell is, and on which level; 0 where no way leads.
typedef struct Walk {
    BBox3D *cells;  // [n_nodes]
    int *levels;    // [n_nodes]
} Walk;

// Walk down from the root; a parent comes before its children. Running out of memory ends the
// program. Release it with walk_free().
Walk walk_down(const KdTree3D *tree);
void walk_free(Walk *walk);

#endif
