// Probe of lab 03: the student's kernel, and one that calls getContainingChild with the job's
// inputs.
#include "image_size.h"

#include "implicit2DRenderer_KD.cl"

#include "no_macros.h"

#include "jobs_03.h"

kernel void probe_children(global const ChildJob *jobs, global const NodeRel *nodes_Relations,
                           global const BBox2D *nodes_BBox, global uint *answers)
{
    const size_t i = get_global_id(0);
    const ChildJob job = jobs[i];
    Work work = {0, 0, 0, 0};
    answers[i] = getContainingChild(job.x, job.y, job.id, nodes_Relations + job.first,
                                    nodes_BBox + job.first, &work);
}
