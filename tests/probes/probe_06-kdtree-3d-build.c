// Probe of lab 06: each of the student's functions on the job's inputs, then whole trees.
#include "kdtree3d_build.h"
#include "probe.h"

#include <stdlib.h>
#include <string.h>

// Write an array as section `name` and free it.
static void answer_array(const Probe *probe, const char *name, void *array, size_t n_bytes)
{
    if (section_write(probe->answers, name, array, n_bytes) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    free(array);
}

static void answer_spheres_bounds(const Probe *probe)
{
    size_t n_bytes;
    const BoundsJob *jobs = probe_job(probe, "bounds", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    BBox3D *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, "bounds", (uint32_t)i);
        answers[i] = spheres_bounds(jobs[i].spheres, jobs[i].n_spheres);
    }
    answer_array(probe, "bounds", answers, n * sizeof *answers);
}

static void answer_choose_split(const Probe *probe)
{
    size_t n_bytes;
    const BBox3D *boxes = probe_job(probe, "splits", &n_bytes);
    const size_t n = n_bytes / sizeof *boxes;
    KdSplit *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, "splits", (uint32_t)i);
        answers[i] = choose_split(boxes[i]);
    }
    answer_array(probe, "splits", answers, n * sizeof *answers);
}

static void answer_sphere_overlaps_box(const Probe *probe)
{
    size_t n_bytes;
    const SphereBoxJob *jobs = probe_job(probe, "overlaps", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, "overlaps", (uint32_t)i);
        answers[i] = sphere_overlaps_box(jobs[i].sphere, jobs[i].box);
    }
    answer_array(probe, "overlaps", answers, n * sizeof *answers);
}

static void answer_distribute_spheres(const Probe *probe)
{
    size_t n_bytes, n_sphere_bytes;
    const DistributeJob3D *jobs = probe_job(probe, "distribute", &n_bytes);
    const Sphere *spheres = probe_scene_part(probe, 0, "spheres", &n_sphere_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    u32 *answers = calloc(n * DISTRIBUTE_ROOM, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        u32 *answer = answers + i * DISTRIBUTE_ROOM;
        for (int j = 0; j < DISTRIBUTE_ROOM; j++) {
            answer[j] = UNTOUCHED;
        }
        probe_note(probe, "distribute", (uint32_t)i);
        answer[0] =
            distribute_spheres(spheres, jobs[i].ids, jobs[i].n_ids, jobs[i].child, answer + 1);
    }
    answer_array(probe, "distribute", answers, n * DISTRIBUTE_ROOM * sizeof *answers);
}

static void answer_pack_leaf_range(const Probe *probe)
{
    size_t n_bytes;
    const PackJob3D *jobs = probe_job(probe, "pack", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    PackAnswer3D *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        PackAnswer3D *answer = &answers[i];
        for (u32 id = 0; id < PACK_NODES; id++) {
            answer->nodes[id] = (KdNode3){.first = UNTOUCHED, .n_spheres = UNTOUCHED};
        }
        for (int j = 0; j < PACK_MAP_ROOM; j++) {
            answer->sphere_ids[j] = UNTOUCHED;
        }
        KdTree3D tree = {.nodes = answer->nodes,
                         .sphere_ids = answer->sphere_ids,
                         .n_nodes = PACK_NODES,
                         .n_sphere_ids = jobs[i].n_sphere_ids};
        probe_note(probe, "pack", (uint32_t)i);
        pack_leaf_range(&tree, jobs[i].id, jobs[i].ids, jobs[i].n_ids);
        answer->n_sphere_ids = tree.n_sphere_ids;
    }
    answer_array(probe, "pack", answers, n * sizeof *answers);
}

static void answer_fits_todo(const Probe *probe)
{
    i32 *answers = calloc(TODO_LEVELS, sizeof *answers);
    for (int level = 1; level <= TODO_LEVELS; level++) {
        probe_note(probe, "todo", (uint32_t)level);
        answers[level - 1] = fits_todo(level);
    }
    answer_array(probe, "todo", answers, TODO_LEVELS * sizeof *answers);
}

static void answer_tree(const Probe *probe, int k, const TreeJob3D *job)
{
    size_t n_bytes;
    const Sphere *spheres = probe_scene_part(probe, k, "spheres", &n_bytes);
    const KdTreeLimits limits = {job->maxDepth, job->targetElementsPerNode};
    KdTree3D tree = {0};
    probe_note(probe, "tree", (uint32_t)k);
    if (kdtree3d_build(spheres, job->n_spheres, limits, &tree) != 0) {
        probe_answer(probe, "tree", k, "refused", "", 0);
        return;
    }
    const TreeAnswer3D answer = {tree.bounds, tree.n_nodes, tree.n_sphere_ids};
    probe_answer(probe, "tree", k, NULL, &answer, sizeof answer);
    if (tree.n_nodes <= TREE3D_ANSWER_NODES && tree.n_sphere_ids <= TREE3D_ANSWER_IDS) {
        probe_answer(probe, "tree", k, "nodes", tree.nodes, tree.n_nodes * sizeof *tree.nodes);
        probe_answer(probe, "tree", k, "ids", tree.sphere_ids,
                     tree.n_sphere_ids * sizeof *tree.sphere_ids);
    }
    tree3d_free(&tree);
}

// Scene number k, or NULL when the job has no more.
static const TreeJob3D *tree_job(const Probe *probe, int k)
{
    char name[SECTION_NAME_BYTES];
    snprintf(name, sizeof name, "scene.%d", k);
    return sections_find(&probe->job, name, sizeof(TreeJob3D));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    answer_spheres_bounds(&probe);
    answer_choose_split(&probe);
    answer_sphere_overlaps_box(&probe);
    answer_distribute_spheres(&probe);
    answer_pack_leaf_range(&probe);
    answer_fits_todo(&probe);
    const TreeJob3D *job;
    for (int k = 0; (job = tree_job(&probe, k)) != NULL; k++) {
        answer_tree(&probe, k, job);
    }
    probe_close(&probe);
    return EXIT_SUCCESS;
}
