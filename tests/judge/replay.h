// Replays: what the builders of labs 02 and 06 call while they build the right trees of a job's
// scenes, node by node. An answer that is tried alone gets the same calls (jobs.h, "Replays").
//
// Nothing here knows how a tree is built: nodes, cells and lists are the oracle's.
#ifndef JUDGE_REPLAY_H
#define JUDGE_REPLAY_H

#include "jobs.h"
#include "sections.h"

#include <stdio.h>

// A node when the builder comes to it.
typedef struct ReplayNode {
    u32 scene;
    u32 id;           // in that scene's tree
    u32 first_child;  // the other one is behind it; 0 for a leaf
    int level;        // 1 for the root
    int n_failed;     // splits above it that failed
    BBox3D cell;      // in 2D z is 0
    u32 first_id;     // where its list starts in Replay's ids
    u32 n_ids;
} ReplayNode;

// Scene by scene, the nodes of each in the order of their ids.
typedef struct Replay {
    ReplayNode *nodes;  // [n_nodes]
    u32 *ids;           // [n_ids]
    u32 n_nodes, node_room;
    u32 n_ids, id_room;
} Replay;

void replay_free(Replay *replay);

// Append a scene's nodes, as leaves on level 1 without lists. Returns the first of them, which
// stays where it is until the next call, or NULL after one message.
ReplayNode *replay_add_scene(Replay *replay, u32 scene, u32 n_nodes);

// Append an id to the list of `node`, the last one that got an id, or one behind it. Returns 0, or
// -1 after one message.
int replay_add_id(Replay *replay, ReplayNode *node, u32 id);

// Once nodes[n_nodes], those of one scene, have their children and lists: set level and n_failed.
//   split_fails   by the numbers of ids in the node, in its lower and in its higher child
void replay_go_down(ReplayNode *nodes, u32 n_nodes, int (*split_fails)(u32, u32, u32));

// How many nodes are not leaves.
size_t replay_n_inner(const Replay *replay);

// Child number 0 or 1 of an inner node.
const ReplayNode *replay_child(const ReplayNode *node, int side);

// ---- Lists --------------------------------------------------------------------------------------

// Shall the child with this cell get an id of its parent's list?
//   job   the lab's
typedef int ReplayKeeps(const void *job, u32 scene, u32 id, BBox3D cell);

// Write "replay.ids" and, of each inner node for both children, "replay.lists". Returns 0, or -1.
int replay_write_lists(const Replay *replay, FILE *file);

// Is this what one call for a node's ids must return and write? found[REPLAY_ROOM(n_ids)]
int replay_list_is_right(const u32 *found, const u32 *ids, u32 n_ids, u32 scene, BBox3D cell,
                         ReplayKeeps *keeps, const void *job);

// Is the answer "replay.lists" there and right?
int replay_lists_are_right(const Replay *replay, const Sections *answers, ReplayKeeps *keeps,
                           const void *job);

// ---- Leaves -------------------------------------------------------------------------------------

// Write "replay.ids", "replay.leaves" and "replay.trees".
//   trees[n_scenes]
// Returns 0, or -1.
int replay_write_leaves(const Replay *replay, const ReplayTree *trees, u32 n_scenes, FILE *file);

#endif
