// Probe of lab 02: each of the student's functions on the job's inputs, then whole trees; or, where
// one answer is tried alone, its function in a replay of the builder's calls (jobs.h).
#include "jobs_02.h"
#include "kdtree2d_build.h"
#include "probe.h"

#include <stdlib.h>
#include <string.h>

static void call_is_leaf(const Probe *probe, const void *input, void *answer)
{
    const LeafJob *job = input;
    const KdTreeLimits limits = {job->maxDepth, job->targetElementsPerNode};
    (void)probe;
    *(i32 *)answer = is_leaf(job->level, job->n_circles, job->n_failed, limits);
}

static void call_split_box(const Probe *probe, const void *input, void *answer)
{
    BBox2D *halves = answer;
    (void)probe;
    split_box(*(const BBox2D *)input, &halves[0], &halves[1]);
}

static void call_circle_overlaps_box(const Probe *probe, const void *input, void *answer)
{
    const BoxOverlapJob *job = input;
    (void)probe;
    *(i32 *)answer = circle_overlaps_box(job->circle, job->box);
}

// There where the address sanitizer is (make memcheck).
extern void __asan_init(void) __attribute__((weak));

// A list of ids in memory of its own, behind whose end the sanitizer sees every read; NULL where
// there is no sanitizer. To be freed.
static u32 *ids_alone(const u32 *ids, u32 n_ids)
{
    u32 *alone = __asan_init != NULL ? malloc(n_ids * sizeof *alone) : NULL;
    return alone != NULL ? memcpy(alone, ids, n_ids * sizeof *alone) : NULL;
}

static void call_distribute(const Probe *probe, const void *input, void *pointer)
{
    size_t n_bytes;
    const DistributeJob *job = input;
    const Circle *circles = probe_scene_part(probe, DISTRIBUTE_SCENE, "circles", &n_bytes);
    u32 *answer = pointer;
    probe_leave_untouched(answer, DISTRIBUTE_ROOM);
    u32 *alone = ids_alone(job->ids, job->n_ids);
    answer[0] =
        distribute(circles, alone != NULL ? alone : job->ids, job->n_ids, job->child, answer + 1);
    free(alone);
}

static void call_pack_leaf(const Probe *probe, const void *input, void *pointer)
{
    const PackJob *job = input;
    PackAnswer *answer = pointer;
    u8 flags[PACK_NODES];
    (void)probe;
    for (u32 id = 0; id < PACK_NODES; id++) {
        answer->relations[id].id = id;
        answer->boxes[id] = PACK_CELL(id);
        flags[id] = INNER;
    }
    probe_leave_untouched(answer->map, PACK_MAP_ROOM);
    KdTree2D tree = {answer->relations, flags,      answer->boxes,
                     answer->map,       PACK_NODES, job->n_before};
    u32 *alone = ids_alone(job->ids, job->n_ids);
    pack_leaf(&tree, job->id, alone != NULL ? alone : job->ids, job->n_ids);
    free(alone);
    for (int id = 0; id < PACK_NODES; id++) {
        answer->flags[id] = flags[id];
    }
    answer->n_map = tree.n_map;
    answer->n_nodes = tree.n_nodes;
}

// ---- Replays ------------------------------------------------------------------------------------

static void replay_distribute(const Probe *probe, const char *name)
{
    size_t n_bytes, n_other;
    const ReplayList *lists = probe_job(probe, name, &n_bytes);
    const BBox2D *cells = probe_job(probe, "replay.cells", &n_other);
    const u32 *ids = probe_job(probe, "replay.ids", &n_other);
    const size_t n = n_bytes / sizeof *lists;
    size_t n_answered = 0;
    for (size_t i = 0; i < n; i++) {
        n_answered += REPLAY_ROOM(lists[i].n_ids);
    }
    u32 *answers = calloc(n_answered, sizeof *answers), *answer = answers;
    for (size_t i = 0; i < n; i++) {
        const Circle *circles = probe_scene_part(probe, (int)lists[i].scene, "circles", &n_other);
        probe_leave_untouched(answer, REPLAY_ROOM(lists[i].n_ids));
        probe_note(probe, name, (uint32_t)i);
        answer[0] =
            distribute(circles, ids + lists[i].first_id, lists[i].n_ids, cells[i], answer + 1);
        answer += REPLAY_ROOM(lists[i].n_ids);
    }
    probe_answer_array(probe, name, answers, n_answered * sizeof *answers);
}

// Pack all leaves of scene K, the first of which is leaves[0], into a tree.
static void pack_tree(const Probe *probe, u32 k, ReplayTree room, const ReplayList *leaves,
                      size_t n_leaves)
{
    size_t n_bytes;
    const u32 *ids = probe_job(probe, "replay.ids", &n_bytes);
    const size_t n_map = (size_t)room.n_entries + REPLAY_GUARD;
    NodeRel *relations = calloc(room.n_nodes, sizeof *relations);
    u8 *flags = calloc(room.n_nodes, sizeof *flags);
    BBox2D *boxes = calloc(room.n_nodes, sizeof *boxes);
    u32 *map = calloc(n_map, sizeof *map);
    for (u32 id = 0; id < room.n_nodes; id++) {
        relations[id].id = id;
        flags[id] = INNER;
    }
    probe_leave_untouched(map, n_map);
    KdTree2D tree = {relations, flags, boxes, map, room.n_nodes, 0};
    // As the builder does: no further with a list that took more room than it needs.
    for (size_t i = 0, end = 0; i < n_leaves && leaves[i].scene == k && tree.n_map <= end; i++) {
        probe_note(probe, "replay.leaves", (uint32_t)i);
        pack_leaf(&tree, leaves[i].node, ids + leaves[i].first_id, leaves[i].n_ids);
        end += 1 + leaves[i].n_ids;
    }
    probe_answer(probe, "packed", (int)k, NULL, &tree.n_map, sizeof tree.n_map);
    probe_answer(probe, "packed", (int)k, "nodes", relations, room.n_nodes * sizeof *relations);
    probe_answer(probe, "packed", (int)k, "flags", flags, room.n_nodes * sizeof *flags);
    probe_answer(probe, "packed", (int)k, "map", map, n_map * sizeof *map);
    free(relations);
    free(flags);
    free(boxes);
    free(map);
}

static void replay_pack_leaf(const Probe *probe, const char *name)
{
    probe_replay_leaves(probe, name, pack_tree);
}

// ---- Whole trees --------------------------------------------------------------------------------

static void answer_tree(const Probe *probe, int k, const SceneJob *scene)
{
    size_t n_bytes;
    const Circle *circles = probe_scene_part(probe, k, "circles", &n_bytes);
    const KdTreeLimits limits = {scene->maxDepth, scene->targetElementsPerNode};
    KdTree2D tree = {0};
    probe_note(probe, "tree", (uint32_t)k);
    const u32 fault = (u32)kdtree2d_build(circles, (u32)scene->n_circles, limits, &tree);
    if (fault != KD_BUILT) {
        probe_answer(probe, "tree", k, "refused", &fault, sizeof fault);
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
    static const ProbeFunction functions[] = {
        {"leaves", sizeof(LeafJob), sizeof(i32), .call = call_is_leaf},
        {"splits", sizeof(BBox2D), 2 * sizeof(BBox2D), .call = call_split_box},
        {"overlaps", sizeof(BoxOverlapJob), sizeof(i32), .call = call_circle_overlaps_box},
        {"distribute", sizeof(DistributeJob), DISTRIBUTE_ROOM * sizeof(u32),
         .call = call_distribute},
        {"pack", sizeof(PackJob), sizeof(PackAnswer), .call = call_pack_leaf},
        {"replay.leaf", sizeof(LeafJob), sizeof(i32), .call = call_is_leaf},
        {"replay.split", sizeof(BBox2D), 2 * sizeof(BBox2D), .call = call_split_box},
        {"replay.overlap", sizeof(BoxOverlapJob), sizeof(i32), .call = call_circle_overlaps_box},
        {"replay.lists", .answer = replay_distribute},
        {"replay.leaves", .answer = replay_pack_leaf},
    };
    Probe probe;
    probe_open(&probe);
    probe_call_host(&probe, functions, sizeof functions / sizeof *functions);
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_tree(&probe, k, scene);
    }
    probe_close(&probe);
    return EXIT_SUCCESS;
}
