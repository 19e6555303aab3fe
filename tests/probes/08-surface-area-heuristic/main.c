// Probe of lab 08: each of the student's functions on the job's inputs, then whole trees.
#include "jobs_08.h"
#include "kdtree3d_sah.h"
#include "probe.h"

#include <stdlib.h>

static void call_surface_area(const Probe *probe, const void *input, void *answer)
{
    (void)probe;
    *(double *)answer = surface_area(*(const BBox3D *)input);
}

static void call_split_cost(const Probe *probe, const void *input, void *answer)
{
    const CostJob *job = input;
    const KdSplit split = {job->axis, job->pos};
    (void)probe;
    *(double *)answer = split_cost(job->box, split, job->n_lower, job->n_higher);
}

static void call_find_best_split(const Probe *probe, const void *input, void *answer)
{
    size_t n_bytes;
    const BestJob *job = input;
    const Sphere *spheres = probe_job(probe, "best_spheres", &n_bytes);
    const u32 *ids = probe_job(probe, "best_ids", &n_bytes);
    const BestSplit best = find_best_split(spheres, ids + job->first_id, job->n_ids, job->box);
    *(BestAnswer *)answer = (BestAnswer){best.split.axis, best.split.pos, best.cost};
}

static void call_is_leaf_by_cost(const Probe *probe, const void *input, void *answer)
{
    const LeafCostJob *job = input;
    const KdTreeLimits limits = {job->maxDepth, job->targetElementsPerNode};
    (void)probe;
    *(i32 *)answer = is_leaf_by_cost(job->level, job->n_spheres, job->best_cost, limits);
}

int main(void)
{
    static const ProbeFunction functions[] = {
        {"areas", sizeof(BBox3D), sizeof(double), .call = call_surface_area},
        {"costs", sizeof(CostJob), sizeof(double), .call = call_split_cost},
        {"bests", sizeof(BestJob), sizeof(BestAnswer), .call = call_find_best_split},
        {"decisions", sizeof(LeafCostJob), sizeof(i32), .call = call_is_leaf_by_cost},
    };
    Probe probe;
    probe_open(&probe);
    probe_call_host(&probe, functions, sizeof functions / sizeof *functions);
    probe_answer_trees(&probe, kdtree3d_build_sah);
    probe_close(&probe);
    return EXIT_SUCCESS;
}
