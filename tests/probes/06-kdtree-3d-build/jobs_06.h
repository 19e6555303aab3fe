// The sections of lab 06's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_06_H
#define PROBES_JOBS_06_H

#include "jobs.h"

// choose_split takes a BBox3D and is answered by a KdSplit of lab 06, which is laid out so.
typedef struct SplitAnswer3D {
    u32 axis;
    f32 pos;
} SplitAnswer3D;
LAYOUT_ASSERT(SplitAnswer3D, 8);

// One call of sphere_overlaps_box. Answered by an i32.
typedef struct SphereBoxJob {
    Sphere sphere;
    BBox3D box;
} SphereBoxJob;
LAYOUT_ASSERT(SphereBoxJob, 40);

// What the tree of a PackJob looks like afterwards; nodes start as PACK_NODE, ids as UNTOUCHED.
#define PACK_SPLIT_POS 3.5f
#define PACK_SPLIT_AXIS 1u
#define PACK_NODE ((KdNode3){PACK_SPLIT_POS, PACK_SPLIT_AXIS, UNTOUCHED, UNTOUCHED})
typedef struct PackAnswer3D {
    KdNode3 nodes[PACK_NODES];
    u32 sphere_ids[PACK_MAP_ROOM];
    u32 n_sphere_ids;
    u32 n_nodes;
} PackAnswer3D;
LAYOUT_ASSERT(PackAnswer3D, 1496);

// Section "todo", and "replay.todo": a level each, twice as long as what answers it, so that no job
// is taken for its answers. fits_todo is called with each; answered by an i32.
typedef int64_t LevelJob;

#endif
