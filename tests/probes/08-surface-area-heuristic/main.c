// Probe of lab 08: each of the student's functions on the job's inputs, then whole trees.
#include "jobs_08.h"
#include "kdtree3d_sah.h"
#include "probe.h"

#include <stdlib.h>

static void answer_surface_area(const Probe *probe, const char *name)
{
    size_t n_bytes;
    const BBox3D *boxes = probe_job(probe, name, &n_bytes);
    const size_t n = n_bytes / sizeof *boxes;
    double *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, name, (uint32_t)i);
        answers[i] = surface_area(boxes[i]);
    }
    probe_answer_array(probe, name, answers, n * sizeof *answers);
}

static void answer_split_cost(const Probe *probe, const char *name)
{
    size_t n_bytes;
    const CostJob *jobs = probe_job(probe, name, &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    double *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const KdSplit split = {jobs[i].axis, jobs[i].pos};
        probe_note(probe, name, (uint32_t)i);
        answers[i] = split_cost(jobs[i].box, split, jobs[i].n_lower, jobs[i].n_higher);
    }
    probe_answer_array(probe, name, answers, n * sizeof *answers);
}

static void answer_find_best_split(const Probe *probe, const char *name)
{
    size_t n_bytes;
    const Sphere *spheres = probe_job(probe, "best_spheres", &n_bytes);
    const u32 *ids = probe_job(probe, "best_ids", &n_bytes);
    const BestJob *jobs = probe_job(probe, name, &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    BestAnswer *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, name, (uint32_t)i);
        const BestSplit best =
            find_best_split(spheres, ids + jobs[i].first_id, jobs[i].n_ids, jobs[i].box);
        answers[i] = (BestAnswer){best.split.axis, best.split.pos, best.cost};
    }
    probe_answer_array(probe, name, answers, n * sizeof *answers);
}

static void answer_is_leaf_by_cost(const Probe *probe, const char *name)
{
    size_t n_bytes;
    const LeafCostJob *jobs = probe_job(probe, name, &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        const KdTreeLimits limits = {jobs[i].maxDepth, jobs[i].targetElementsPerNode};
        probe_note(probe, name, (uint32_t)i);
        answers[i] = is_leaf_by_cost(jobs[i].level, jobs[i].n_spheres, jobs[i].best_cost, limits);
    }
    probe_answer_array(probe, name, answers, n * sizeof *answers);
}

int main(void)
{
    static const struct {
        const char *name;  // of a section
        void (*answer)(const Probe *probe, const char *name);
    } functions[] = {
        {"areas", answer_surface_area},
        {"costs", answer_split_cost},
        {"bests", answer_find_best_split},
        {"decisions", answer_is_leaf_by_cost},
    };
    Probe probe;
    probe_open(&probe);
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        if (probe_asks(&probe, functions[i].name)) {
            functions[i].answer(&probe, functions[i].name);
        }
    }
    probe_answer_trees(&probe, kdtree3d_build_sah);
    probe_close(&probe);
    return EXIT_SUCCESS;
}
