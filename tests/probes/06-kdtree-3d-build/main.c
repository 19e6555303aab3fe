// Probe of lab 06: each of the student's functions on the job's inputs, then whole trees; or, where
// one answer is tried alone, its function in a replay of the builder's calls (jobs.h).
#include "jobs_06.h"
#include "kdtree3d_build.h"
#include "probe.h"

#include <stdlib.h>
#include <string.h>

// Leave large numbers below in the stack, where the next call's cell will lie: who reads a fourth
// side of it, behind its end, shall find the longest one. What is found there C does not say; all
// that is done here it does.
__attribute__((noinline)) static void stack_paint(void)
{
    volatile f32 below[128];
    for (size_t i = 0; i < sizeof below / sizeof *below; i++) {
        below[i] = BEYOND_RADIUS;
    }
}

// A call with a frame of its own, all of it on the paint.
__attribute__((noinline)) static KdSplit choose_on_paint(const BBox3D *cell)
{
    const KdSplit split = choose_split(*cell);
    return split;
}

static void call_choose_split(const Probe *probe, const void *input, void *answer)
{
    (void)probe;
    stack_paint();
    *(KdSplit *)answer = choose_on_paint(input);
}

static void call_sphere_overlaps_box(const Probe *probe, const void *input, void *answer)
{
    const SphereBoxJob *job = input;
    (void)probe;
    *(i32 *)answer = sphere_overlaps_box(job->sphere, job->box);
}

static void call_pack_leaf_range(const Probe *probe, const void *input, void *pointer)
{
    const PackJob *job = input;
    PackAnswer3D *answer = pointer;
    (void)probe;
    for (u32 id = 0; id < PACK_NODES; id++) {
        answer->nodes[id] = PACK_NODE;
    }
    probe_leave_untouched(answer->sphere_ids, PACK_MAP_ROOM);
    KdTree3D tree = {.nodes = answer->nodes,
                     .sphere_ids = answer->sphere_ids,
                     .n_nodes = PACK_NODES,
                     .n_sphere_ids = job->n_before};
    pack_leaf_range(&tree, job->id, job->ids, job->n_ids);
    answer->n_sphere_ids = tree.n_sphere_ids;
    answer->n_nodes = tree.n_nodes;
}

static void call_fits_todo(const Probe *probe, const void *input, void *answer)
{
    (void)probe;
    *(i32 *)answer = fits_todo((int)*(const LevelJob *)input);
}

// ---- Replays ------------------------------------------------------------------------------------

// Pack all leaves of scene K, the first of which is leaves[0], into a tree.
static void pack_tree(const Probe *probe, u32 k, ReplayTree room, const ReplayList *leaves,
                      size_t n_leaves)
{
    size_t n_bytes;
    const u32 *ids = probe_job(probe, "replay.ids", &n_bytes);
    const size_t n_ids = (size_t)room.n_entries + REPLAY_GUARD;
    KdNode3 *nodes = calloc(room.n_nodes, sizeof *nodes);
    u32 *sphere_ids = calloc(n_ids, sizeof *sphere_ids);
    for (u32 id = 0; id < room.n_nodes; id++) {
        nodes[id] = PACK_NODE;
    }
    probe_leave_untouched(sphere_ids, n_ids);
    KdTree3D tree = {.nodes = nodes, .sphere_ids = sphere_ids, .n_nodes = room.n_nodes};
    // As the builder does: no further with a list that took more room than it needs.
    u32 end = 0;
    for (size_t i = 0; i < n_leaves && leaves[i].scene == k && tree.n_sphere_ids <= end; i++) {
        probe_note(probe, "replay.leaves", (uint32_t)i);
        pack_leaf_range(&tree, leaves[i].node, ids + leaves[i].first_id, leaves[i].n_ids);
        end += leaves[i].n_ids;
    }
    probe_answer(probe, "packed", (int)k, NULL, &tree.n_sphere_ids, sizeof tree.n_sphere_ids);
    probe_answer(probe, "packed", (int)k, "nodes", nodes, room.n_nodes * sizeof *nodes);
    probe_answer(probe, "packed", (int)k, "map", sphere_ids, n_ids * sizeof *sphere_ids);
    free(nodes);
    free(sphere_ids);
}

static void replay_pack_leaf(const Probe *probe, const char *name)
{
    probe_replay_leaves(probe, name, pack_tree);
}

int main(void)
{
    static const ProbeFunction functions[] = {
        {"splits", sizeof(BBox3D), sizeof(KdSplit), .call = call_choose_split},
        {"overlaps", sizeof(SphereBoxJob), sizeof(i32), .call = call_sphere_overlaps_box},
        {"pack", sizeof(PackJob), sizeof(PackAnswer3D), .call = call_pack_leaf_range},
        {"todo", sizeof(LevelJob), sizeof(i32), .call = call_fits_todo},
        {"replay.split", sizeof(BBox3D), sizeof(KdSplit), .call = call_choose_split},
        {"replay.overlap", sizeof(SphereBoxJob), sizeof(i32), .call = call_sphere_overlaps_box},
        {"replay.leaves", .answer = replay_pack_leaf},
        {"replay.todo", sizeof(LevelJob), sizeof(i32), .call = call_fits_todo},
    };
    Probe probe;
    probe_open(&probe);
    probe_call_host(&probe, functions, sizeof functions / sizeof *functions);
    probe_answer_trees(&probe, kdtree3d_build);
    probe_close(&probe);
    return EXIT_SUCCESS;
}
