// Replays: what the builders of labs 02 and 06 call while they build the right trees of a job's
// scenes, node by node. An answer that is tried alone gets the same calls (jobs.h, "Replays").
//
// Nothing here knows how a tree is built: nodes, cells and lists are the oracle's (oracle_tree.h).
#ifndef JUDGE_REPLAY_H
#define JUDGE_REPLAY_H

#include "diagnosis.h"
#include "jobs.h"
#include "oracle_tree.h"
#include "sections.h"

#include <stdio.h>

// For what a function is called.
typedef enum ReplayEach {
    EACH_NODE,
    EACH_INNER_NODE,
    EACH_CHILD,          // of each inner node
    EACH_ID_OF_A_CHILD,  // each id of an inner node, for either child
} ReplayEach;

typedef struct ReplayCall {
    const GrownNode *node;
    const GrownNode *child;  // NULL where the call is for a node
    u32 id;                  // of EACH_ID_OF_A_CHILD
} ReplayCall;

// The calls of one function.
typedef struct Replay {
    const char *section;  // of the job and of the answers
    ReplayEach each;
    size_t input_bytes, answer_bytes;
    void (*input)(const void *job, ReplayCall call, void *input);
    int (*is_right)(const void *job, ReplayCall call, const void *answer);
} Replay;

// Write the inputs of all calls. Returns 0, or -1.
int replay_write(const Replay *replay, const Growth *growth, const void *job, FILE *file);

// Are all answers there, and right?
int replay_is_right(const Replay *replay, const Growth *growth, const void *job,
                    const Sections *answers);

// ---- Lists --------------------------------------------------------------------------------------

// A call of distribute or distribute_spheres.
typedef struct ListCall {
    u32 scene;
    const u32 *ids;  // [n_ids], the parent's
    u32 n_ids;
    BBox3D cell;  // the child's
} ListCall;

// Shall the child with this cell get an id of its parent's list?
//   job   the lab's
typedef int ListKeeps(const void *job, u32 scene, u32 id, BBox3D cell);

// Is this what the call must return and write? found[REPLAY_ROOM(n_ids)]
int list_is_right(ListCall call, ListKeeps *keeps, const void *job, const u32 *found);

// Write "replay.ids" and, of each inner node for both children, "replay.lists". Returns 0, or -1.
int replay_write_lists(const Growth *growth, FILE *file);

// Is the answer "replay.lists" there and right?
int replay_lists_are_right(const Growth *growth, const Sections *answers, ListKeeps *keeps,
                           const void *job);

// ---- Leaves -------------------------------------------------------------------------------------

// Write "replay.ids", "replay.leaves" and "replay.trees".
//   trees[n_scenes]
// Returns 0, or -1.
int replay_write_leaves(const Growth *growth, const ReplayTree *trees, u32 n_scenes, FILE *file);

// Are the REPLAY_GUARD entries behind an array as they were?
int guard_is_untouched(const u32 *guard);

#endif
