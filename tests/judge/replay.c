// Keeping, writing and judging replays (see replay.h).
#include "replay.h"

#include <stdlib.h>
#include <string.h>

void replay_free(Replay *replay)
{
    free(replay->nodes);
    free(replay->ids);
    *replay = (Replay){0};
}

// Room for n more of *used elements. Returns 0, or -1 after one message.
static int make_room(void **array, u32 used, u32 n, u32 *room, size_t n_bytes)
{
    if (n <= *room - used) {
        return 0;
    }
    const size_t larger = 2 * ((size_t)used + n);
    void *moved = realloc(*array, larger * n_bytes);
    if (moved == NULL) {
        fprintf(stderr, "grade: no memory for a replay\n");
        return -1;
    }
    *array = moved;
    *room = (u32)larger;
    return 0;
}

ReplayNode *replay_add_scene(Replay *replay, u32 scene, u32 n_nodes)
{
    void *nodes = replay->nodes;
    if (make_room(&nodes, replay->n_nodes, n_nodes, &replay->node_room, sizeof *replay->nodes) !=
        0) {
        return NULL;
    }
    replay->nodes = nodes;
    ReplayNode *first = replay->nodes + replay->n_nodes;
    for (u32 id = 0; id < n_nodes; id++) {
        first[id] = (ReplayNode){.scene = scene, .id = id, .level = 1};
    }
    replay->n_nodes += n_nodes;
    return first;
}

int replay_add_id(Replay *replay, ReplayNode *node, u32 id)
{
    void *ids = replay->ids;
    if (make_room(&ids, replay->n_ids, 1, &replay->id_room, sizeof *replay->ids) != 0) {
        return -1;
    }
    replay->ids = ids;
    if (node->n_ids == 0) {
        node->first_id = replay->n_ids;
    }
    node->n_ids++;
    replay->ids[replay->n_ids++] = id;
    return 0;
}

void replay_go_down(ReplayNode *nodes, u32 n_nodes, int (*split_fails)(u32, u32, u32))
{
    for (u32 id = 0; id < n_nodes; id++) {
        const ReplayNode *node = &nodes[id];
        if (node->first_child == 0) {
            continue;
        }
        ReplayNode *children = nodes + node->first_child;
        children[0].level = children[1].level = node->level + 1;
        children[0].n_failed = children[1].n_failed =
            node->n_failed + split_fails(node->n_ids, children[0].n_ids, children[1].n_ids);
    }
}

size_t replay_n_inner(const Replay *replay)
{
    size_t n = 0;
    for (u32 i = 0; i < replay->n_nodes; i++) {
        n += replay->nodes[i].first_child != 0;
    }
    return n;
}

const ReplayNode *replay_child(const ReplayNode *node, int side)
{
    return node - node->id + node->first_child + side;
}

// ---- Lists --------------------------------------------------------------------------------------

static ReplayList list_of(const ReplayNode *node)
{
    return (ReplayList){node->scene, node->id, node->first_id, node->n_ids};
}

// Write the lists of all leaves, or of all other nodes, each of these `n_times`. Returns 0, or -1.
static int write_lists(const Replay *replay, const char *name, int of_leaves, int n_times,
                       FILE *file)
{
    ReplayList *lists = calloc((size_t)n_times * replay->n_nodes + 1, sizeof *lists);
    size_t n = 0;
    for (u32 i = 0; lists != NULL && i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        for (int time = 0; time < n_times && (node->first_child == 0) == of_leaves; time++) {
            lists[n++] = list_of(node);
        }
    }
    const int result = lists == NULL ? -1 : section_write(file, name, lists, n * sizeof *lists);
    free(lists);
    return result;
}

static int write_ids(const Replay *replay, FILE *file)
{
    return section_write(file, "replay.ids", replay->ids, replay->n_ids * sizeof *replay->ids);
}

int replay_write_lists(const Replay *replay, FILE *file)
{
    return write_ids(replay, file) | write_lists(replay, "replay.lists", 0, 2, file);
}

int replay_list_is_right(const u32 *found, const u32 *ids, u32 n_ids, u32 scene, BBox3D cell,
                         ReplayKeeps *keeps, const void *job)
{
    u32 n = 0;
    for (u32 i = 0; i < n_ids; i++) {
        if (keeps(job, scene, ids[i], cell)) {
            if (found[1 + n] != ids[i]) {
                return 0;
            }
            n++;
        }
    }
    int is_right = found[0] == n;
    for (int i = 0; i < REPLAY_GUARD; i++) {
        is_right = is_right && found[1 + n_ids + (u32)i] == UNTOUCHED;
    }
    return is_right;
}

// How many entries all answers have together.
static size_t n_answered(const Replay *replay)
{
    size_t n = 0;
    for (u32 i = 0; i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        n += node->first_child != 0 ? 2 * REPLAY_ROOM(node->n_ids) : 0;
    }
    return n;
}

int replay_lists_are_right(const Replay *replay, const Sections *answers, ReplayKeeps *keeps,
                           const void *job)
{
    const u32 *found = sections_find(answers, "replay.lists", n_answered(replay) * sizeof *found);
    int is_right = found != NULL;
    for (u32 i = 0; is_right && i < replay->n_nodes; i++) {
        const ReplayNode *node = &replay->nodes[i];
        for (int side = 0; is_right && node->first_child != 0 && side < 2; side++) {
            is_right =
                replay_list_is_right(found, replay->ids + node->first_id, node->n_ids, node->scene,
                                     replay_child(node, side)->cell, keeps, job);
            found += REPLAY_ROOM(node->n_ids);
        }
    }
    return is_right;
}

// ---- Leaves -------------------------------------------------------------------------------------

int replay_write_leaves(const Replay *replay, const ReplayTree *trees, u32 n_scenes, FILE *file)
{
    return write_ids(replay, file) | write_lists(replay, "replay.leaves", 1, 1, file) |
           section_write(file, "replay.trees", trees, n_scenes * sizeof *trees);
}
