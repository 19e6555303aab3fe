// The sections of lab 01's job, and of the answers, besides those in jobs.h.
#ifndef PROBES_JOBS_01_H
#define PROBES_JOBS_01_H

#include "jobs.h"

// One call of overlaps_N_Nearer. Answered by an i32.
typedef struct OverlapJob {
    Circle circle;
    i32 x;
    i32 y;
    f32 minDepth;
    i32 unused;
} OverlapJob;
LAYOUT_ASSERT(OverlapJob, 48);

#endif
