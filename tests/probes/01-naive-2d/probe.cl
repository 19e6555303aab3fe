// Probe of lab 01: the student's kernel, and one that calls overlaps_N_Nearer with the job's
// inputs.
#include "image_size.h"

#include "implicit2DRenderer.cl"

#include "no_macros.h"

#include "jobs_01.h"

kernel void probe_overlaps(global const OverlapJob *jobs, global int *answers)
{
    const size_t i = get_global_id(0);
    const OverlapJob job = jobs[i];
    Work work = {0, 0, 0, 0};
    answers[i] = overlaps_N_Nearer(job.x, job.y, job.circle, job.minDepth, &work);
}
