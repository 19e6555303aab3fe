// Probe of lab 02: each of the student's functions on the job's inputs, then whole trees.
#include "kdtree2d_build.h"
#include "probe.h"

#include <stdio.h>
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

static void answer_is_leaf(const Probe *probe)
{
    size_t n_bytes;
    const LeafJob *jobs = probe_job(probe, "leaves", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, "leaves", (uint32_t)i);
        const KdTreeLimits limits = {jobs[i].maxDepth, jobs[i].targetElementsPerNode};
        answers[i] = is_leaf(jobs[i].level, jobs[i].n_circles, jobs[i].n_failed, limits);
    }
    answer_array(probe, "leaves", answers, n * sizeof *answers);
}

static void answer_split_box(const Probe *probe)
{
    size_t n_bytes;
    const BBox2D *boxes = probe_job(probe, "splits", &n_bytes);
    const size_t n = n_bytes / sizeof *boxes;
    BBox2D *answers = calloc(2 * n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, "splits", (uint32_t)i);
        split_box(boxes[i], &answers[2 * i], &answers[2 * i + 1]);
    }
    answer_array(probe, "splits", answers, 2 * n * sizeof *answers);
}

static void answer_circle_overlaps_box(const Probe *probe)
{
    size_t n_bytes;
    const BoxOverlapJob *jobs = probe_job(probe, "overlaps", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    i32 *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        probe_note(probe, "overlaps", (uint32_t)i);
        answers[i] = circle_overlaps_box(jobs[i].circle, jobs[i].box);
    }
    answer_array(probe, "overlaps", answers, n * sizeof *answers);
}

static void answer_distribute(const Probe *probe)
{
    size_t n_bytes, n_circle_bytes;
    const DistributeJob *jobs = probe_job(probe, "distribute", &n_bytes);
    const Circle *circles = probe_scene_part(probe, 0, "circles", &n_circle_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    u32 *answers = calloc(n * DISTRIBUTE_ROOM, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        u32 *answer = answers + i * DISTRIBUTE_ROOM;
        for (int j = 0; j < DISTRIBUTE_ROOM; j++) {
            answer[j] = UNTOUCHED;
        }
        probe_note(probe, "distribute", (uint32_t)i);
        answer[0] = distribute(circles, jobs[i].ids, jobs[i].n_ids, jobs[i].child, answer + 1);
    }
    answer_array(probe, "distribute", answers, n * DISTRIBUTE_ROOM * sizeof *answers);
}

static void answer_pack_leaf(const Probe *probe)
{
    size_t n_bytes;
    const PackJob *jobs = probe_job(probe, "pack", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    PackAnswer *answers = calloc(n, sizeof *answers);
    for (size_t i = 0; i < n; i++) {
        PackAnswer *answer = &answers[i];
        u8 flags[PACK_NODES];
        BBox2D boxes[PACK_NODES] = {{0}};
        for (u32 id = 0; id < PACK_NODES; id++) {
            answer->relations[id].id = id;
            flags[id] = INNER;
        }
        for (int j = 0; j < PACK_MAP_ROOM; j++) {
            answer->map[j] = UNTOUCHED;
        }
        KdTree2D tree = {answer->relations, flags, boxes, answer->map, PACK_NODES, jobs[i].n_map};
        probe_note(probe, "pack", (uint32_t)i);
        pack_leaf(&tree, jobs[i].id, jobs[i].ids, jobs[i].n_ids);
        for (int id = 0; id < PACK_NODES; id++) {
            answer->flags[id] = flags[id];
        }
        answer->n_map = tree.n_map;
    }
    answer_array(probe, "pack", answers, n * sizeof *answers);
}

// Why the builder gave up, by its own message.
static u32 refusal_of(const char *message)
{
    return strstr(message, "distribute() returned more") ? TREE_OF_TOO_MANY_IDS
           : strstr(message, "pack_leaf() moved n_map")  ? TREE_OF_LONG_LISTS
                                                         : TREE_TOO_LARGE;
}

// Build a tree. Returns N_TREE_REFUSALS, or why there is none. The builder tells that on stderr
// only, which is taken for as long as it is at work.
static u32 tree_build(const Circle *circles, const SceneJob *scene, KdTree2D *tree)
{
    const KdTreeLimits limits = {scene->maxDepth, scene->targetElementsPerNode};
    char *text = NULL;
    size_t n_bytes = 0;
    FILE *const usual = stderr, *taken = open_memstream(&text, &n_bytes);
    stderr = taken ? taken : usual;
    const int result = kdtree2d_build(circles, (u32)scene->n_circles, limits, tree);
    stderr = usual;
    if (taken != NULL) {
        fclose(taken);
    }
    const u32 refusal = result == 0 ? N_TREE_REFUSALS : refusal_of(text ? text : "");
    fputs(text ? text : "", stderr);
    free(text);
    return refusal;
}

static void answer_tree(const Probe *probe, int k, const SceneJob *scene)
{
    size_t n_bytes;
    const Circle *circles = probe_scene_part(probe, k, "circles", &n_bytes);
    KdTree2D tree = {0};
    probe_note(probe, "tree", (uint32_t)k);
    const u32 refusal = tree_build(circles, scene, &tree);
    if (refusal != N_TREE_REFUSALS) {
        probe_answer(probe, "tree", k, "refused", &refusal, sizeof refusal);
        return;
    }
    const TreeAnswer answer = {tree.n_nodes, tree.n_map};
    probe_answer(probe, "tree", k, NULL, &answer, sizeof answer);
    probe_answer(probe, "tree", k, "relations", tree.nodes_Relations,
                 tree.n_nodes * sizeof *tree.nodes_Relations);
    probe_answer(probe, "tree", k, "flags", tree.nodes_flag,
                 tree.n_nodes * sizeof *tree.nodes_flag);
    probe_answer(probe, "tree", k, "boxes", tree.nodes_BBox,
                 tree.n_nodes * sizeof *tree.nodes_BBox);
    probe_answer(probe, "tree", k, "map", tree.mapNode2Circles,
                 tree.n_map * sizeof *tree.mapNode2Circles);
    tree2d_free(&tree);
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    answer_is_leaf(&probe);
    answer_split_box(&probe);
    answer_circle_overlaps_box(&probe);
    answer_distribute(&probe);
    answer_pack_leaf(&probe);
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_tree(&probe, k, scene);
    }
    probe_close(&probe);
    return EXIT_SUCCESS;
}
