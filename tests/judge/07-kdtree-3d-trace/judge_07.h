// What lab 07's judge asks of a submission: inputs of its functions, and scenes with their trees.
// Inputs are rolled in judge_07_inputs.c, or are what whole pictures send (judge_07_sent.c); those
// that stand in every job are in judge_07_edges.c.
// They are judged in judge_07_clip.c, judge_07_side.c, judge_07_planes.c, judge_07_leaf.c and
// judge_07_once.c; those of the search's two steps are rolled and judged in judge_07_children.c and
// judge_07_waiting.c. Scenes are rolled in judge_07_scenes.c and judged in judge_07.c.
#ifndef JUDGE_JUDGE_07_H
#define JUDGE_JUDGE_07_H

#include "job_scene3d.h"
#include "jobs_07.h"
#include "judge.h"
#include "oracle3d_rounding.h"
#include "span.h"

// ---- Functions --------------------------------------------------------------------------------

// How many inputs of each range are at most what whole pictures send: the first ones; of leaves
// those behind the first.
enum { N_SENT_CLIPS = 400, N_SENT_SIDES = 400, N_SENT_PLANES = 1000, N_SENT_LEAVES = 200 };

// How many inputs each range has; a function's ranges follow one another.
enum {
    N_CLIP_INPUTS = N_SENT_CLIPS + 500,    // 4 ranges, see ClipRange
    N_SIDE_INPUTS = N_SENT_SIDES + 400,    // 2: the eye beside the plane, mostly on it
    N_PLANE_INPUTS = N_SENT_PLANES + 500,  // 3: the plane ahead, behind the eye, along the ray
    N_LEAF_INPUTS = N_SENT_LEAVES + 240,   // 2: spheres of different places, some of them twice
    N_CHILD_INPUTS = 300,                  // 2 ranges: where one child is met, and where both are
    N_WAITING_INPUTS = 400,
    LEAF_MAX_SPHERES = 12,
    N_LEAVES = 2 * N_LEAF_INPUTS,
    // One leaf of the first range is longer than 8 bits count, with ids and places beyond 16 bits.
    N_LONG_LEAF = 300,
    FIRST_LONG_ID = 1 << 16,
    // Before and behind each leaf's ids stands one more, which must not be asked.
    N_SHORT_LEAF_IDS = N_LEAVES * (LEAF_MAX_SPHERES + 2),
    N_LEAF_IDS = FIRST_LONG_ID + N_LONG_LEAF + 2,
};

enum ClipRange { CLIP_FROM_OUTSIDE, CLIP_PART, CLIP_BESIDE, CLIP_ALONG, N_CLIP_RANGES };
enum PlaneRange { PLANES_AHEAD, PLANES_BEHIND, PLANES_ALONG, N_PLANE_RANGES };

// A leaf's guards are around the eye, nearer than all.
#define GUARD_RADIUS 0x1p-10f

typedef struct Inputs07 {
    ClipJob clips[N_CLIP_RANGES * N_CLIP_INPUTS];
    SideJob sides[2 * N_SIDE_INPUTS];
    PlaneJob planes[N_PLANE_RANGES * N_PLANE_INPUTS];
    SearchJob leaves[N_LEAVES];
    u32 leaf_ids[N_LEAF_IDS];
    // As many as there are ids: who takes a position for an id finds another sphere.
    Sphere leaf_spheres[N_LEAF_IDS];
    NextChildJob children[2 * N_CHILD_INPUTS];
    NextWaitingJob waiting[N_WAITING_INPUTS];
} Inputs07;

void roll_inputs_07(Random *random, Inputs07 *inputs);

// Parts of it.
void roll_child_inputs_07(Random *random, Inputs07 *inputs);
void roll_waiting_inputs_07(Random *random, Inputs07 *inputs);

// What a crash of next_waiting with this NextWaitingJob comes from, or NULL.
const char *suspect_waiting_07(const void *input);

// Put the inputs that stand in every job into the places of rolled ones, at the end of each range.
void inputs_07_set_edges(Inputs07 *inputs);

// The functions; of search_leaf and next_waiting one for each property that is judged. The message
// about one names the mistake that explains every answer in the range.
extern const Function clip_07, side_07, plane_07, leaf_nearest_07, leaf_ids_07, leaf_once_07;
extern const Function child_07, waiting_end_07, waiting_next_07;

// Alone, beside the stubs: is next_child right wherever one child is met, where both are, and
// everywhere? Whole scenes need all tasks; in their place stand all inputs of the two steps.
int one_child_alone_07(const void *job, const JudgeCheck *check, const Sections *answers);
int both_children_alone_07(const void *job, const JudgeCheck *check, const Sections *answers);
int children_alone_07(const void *job, const JudgeCheck *check, const Sections *answers);

// An answer that is wrong only so near to a border was compared with an epsilon; in units of t or
// of a scene. Epsilons are smaller.
#define HAIR 0.01

// ---- Scenes -----------------------------------------------------------------------------------

// In the order of the job.
enum {
    RANDOM = 0,
    N_RANDOM = 20,
    EDGES = RANDOM + N_RANDOM,
    N_NAMED = 9,             // scenes of scene3d.h
    DEEP = EDGES + N_NAMED,  // a tree that needs the whole todo stack
    TOUCHING,                // hits on the side of the scene's box
    TIE,                     // one ray, two spheres: see roll_tie()
    TIP,                     // hits that rounding puts before the leaf they are in
    N_EDGES = TIP + 1 - EDGES,
    FLAKE = EDGES + N_EDGES,
    DECOYS,  // leaves list what does not lie in them: see judge_07_decoys.c
    N_SCENES,
};

// Roll the scenes, with their trees and what is expected. Returns 0, or -1 after one message.
int roll_scenes_07(Random *random, JobScene3D scenes[N_SCENES]);

// Put what the search sends for whole pictures among the inputs, at the beginning of each range.
void inputs_07_add_sent(Random *random, const JobScene3D scenes[N_SCENES], Inputs07 *inputs);

// The scene with decoys. Returns 0, or -1 after one message.
int roll_decoys_07(Random *random, JobScene3D *scene);

// Of what the oracle expects there let only those rays count that no right search lets meet one.
void decoys_07_expect(JobScene3D *scene);

// ---- The job ----------------------------------------------------------------------------------

typedef struct Job07 {
    Job job;
    Inputs07 inputs;
    JobScene3D scenes[N_SCENES];
} Job07;

#endif
