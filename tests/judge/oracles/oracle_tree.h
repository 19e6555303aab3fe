// A kd-tree as the oracle grows it, in 2D and in 3D: node by node, what a builder meets on its way.
// It shares no code with the labs.
//
// Nothing is handed down from parent to child: every cell asks every circle or sphere, in double
// precision. Who packs such a tree: oracle2d_tree.c and tree3d_expected.c. Who gives the same calls
// to an answer that is tried alone: replay.h.
#ifndef JUDGE_ORACLE_TREE_H
#define JUDGE_ORACLE_TREE_H

#include "kdtree3d.h"
#include "layout.h"
#include "tree2d.h"

// A node when the builder comes to it.
typedef struct GrownNode {
    u32 scene;
    u32 id;           // in that scene's tree
    u32 first_child;  // the other one is behind it; 0 for a leaf
    u32 split_axis;   // of an inner node
    int level;        // 1 for the root
    int n_failed;     // splits above it that failed
    BBox3D cell;      // in 2D z is 0
    u32 first_id;     // where its list starts in Growth's ids; 0 when that is empty
    u32 n_ids;
} GrownNode;

// Scene by scene, the nodes of each in breadth-first order: an id is a position among them.
typedef struct Growth {
    GrownNode *nodes;  // [n_nodes]
    u32 *ids;          // [n_ids]
    u32 n_nodes, node_room;
    u32 n_ids, id_room;
} Growth;

// What the steps of building give for one scene.
typedef struct GrowthRules {
    const void *scene;
    u32 n_elements;  // circles or spheres
    int (*overlaps)(const void *scene, u32 id, BBox3D cell);
    // The lower half first. Returns the axis.
    u32 (*halve)(BBox3D cell, BBox3D halves[2]);
    KdTreeLimits limits;
} GrowthRules;

// Does a node stay a leaf?
//   n_failed   how many splits above it failed
int oracle_is_leaf(int level, u32 n_ids, int n_failed, KdTreeLimits limits);

// Do both halves of a cell keep nearly all that is in it?
int oracle_split_fails(u32 n_ids, u32 n_lower, u32 n_higher);

// Grow a scene's tree behind those of the scenes before it. Returns 0, or -1 after one message.
int growth_add(Growth *growth, u32 scene, BBox3D root, const GrowthRules *rules);

void growth_free(Growth *growth);

// The nodes of one scene's tree.
const GrownNode *growth_nodes(const Growth *growth, u32 scene, u32 *n_nodes);

// Child number 0 or 1 of an inner node.
const GrownNode *grown_child(const GrownNode *node, int side);

#endif
