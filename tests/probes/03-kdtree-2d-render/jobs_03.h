// The sections of lab 03's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_03_H
#define PROBES_JOBS_03_H

#include "jobs.h"

// One call of getContainingChild on the nodes in sections "children.relations" and
// "children.boxes", from node `first` on. Answered by a u32.
typedef struct ChildJob {
    i32 x;
    i32 y;
    u32 id;
    u32 first;
} ChildJob;
LAYOUT_ASSERT(ChildJob, 16);

// The alpha of a circle that every list of a leaf map names, nearest of all and everywhere, and
// that the probe's overlaps_N_Nearer never takes (overlaps_N_Nearer.cl).
#define UNTAKEN (-1.0f)

#endif
