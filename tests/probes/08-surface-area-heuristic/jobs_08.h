// The sections of lab 08's job, and of the answers: as jobs.h has those of the others.
//
// Its scenes are like those of lab 06, and so are the answers about their trees.
#ifndef PROBES_JOBS_08_H
#define PROBES_JOBS_08_H

#include "jobs.h"

// Section "areas", one call of surface_area each, a BBox3D. Answered by a double.

// Section "costs", one call of split_cost each. Answered by a double.
typedef struct CostJob {
    BBox3D box;
    u32 axis;
    f32 pos;
    u32 n_lower;
    u32 n_higher;
} CostJob;
LAYOUT_ASSERT(CostJob, 40);

// Section "bests", one call of find_best_split each, with the spheres of section "best_spheres" and
// ids of section "best_ids".
typedef struct BestJob {
    BBox3D box;
    u32 first_id;  // where the node's ids start in section "best_ids"
    u32 n_ids;
} BestJob;
LAYOUT_ASSERT(BestJob, 32);

typedef struct BestAnswer {
    u32 axis;
    f32 pos;
    double cost;
} BestAnswer;
LAYOUT_ASSERT(BestAnswer, 16);

// Section "decisions", one call of is_leaf_by_cost each. Answered by an i32.
typedef struct LeafCostJob {
    i32 level;
    u32 n_spheres;
    double best_cost;
    i32 maxDepth;
    i32 targetElementsPerNode;
} LeafCostJob;
LAYOUT_ASSERT(LeafCostJob, 24);

#endif
