// The sections of lab 02's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_02_H
#define PROBES_JOBS_02_H

#include "jobs.h"

// One call of is_leaf. Answered by an i32.
typedef struct LeafJob {
    i32 level;
    u32 n_circles;
    i32 maxDepth;
    i32 targetElementsPerNode;
    i32 n_failed;
} LeafJob;
LAYOUT_ASSERT(LeafJob, 20);

// split_box takes a BBox2D and is answered by two, left and right.

// One call of circle_overlaps_box. Answered by an i32.
typedef struct BoxOverlapJob {
    Circle circle;
    BBox2D box;
} BoxOverlapJob;
LAYOUT_ASSERT(BoxOverlapJob, 48);

// distribute is called with ids of the circles of scene DISTRIBUTE_SCENE; the answer has
// DISTRIBUTE_ROOM entries: the number returned, then child_ids, UNTOUCHED where nothing was
// written.
enum { DISTRIBUTE_SCENE = 6, DISTRIBUTE_MAX_IDS = 600, DISTRIBUTE_ROOM = DISTRIBUTE_MAX_IDS + 8 };
typedef struct DistributeJob {
    BBox2D child;
    u32 n_ids;
    u32 ids[DISTRIBUTE_MAX_IDS];
} DistributeJob;
LAYOUT_ASSERT(DistributeJob, 2420);

// What the tree looks like afterwards; nodes start as {id = position, rest 0}, flags as INNER,
// cells as PACK_CELL, the map as UNTOUCHED.
typedef struct PackAnswer {
    NodeRel relations[PACK_NODES];
    u32 flags[PACK_NODES];
    BBox2D boxes[PACK_NODES];
    u32 map[PACK_MAP_ROOM];
    u32 n_map;
    u32 n_nodes;
} PackAnswer;
LAYOUT_ASSERT(PackAnswer, 1656);
#define PACK_CELL(id) ((BBox2D){(f32)(id), (f32)(id) + 2, 1, 3})

// Scene K is answered with "tree.K" and the four arrays "tree.K.relations", ".flags", ".boxes"
// and ".map"; with "tree.K.refused", a KdFault as a u32, where the builder gave up.
typedef struct TreeAnswer {
    u32 n_nodes;
    u32 n_map;
} TreeAnswer;
LAYOUT_ASSERT(TreeAnswer, 8);

#endif
