// What lab 07's judge asks of a submission: inputs of its functions, and scenes with their trees.
// Inputs are drawn in judge_07_inputs.c and judged in judge_07_clip.c, judge_07_functions.c and
// judge_07_leaf.c; those of the search's two steps are drawn and judged in judge_07_children.c and
// judge_07_waiting.c. Scenes are drawn in judge_07_scenes.c and judged in judge_07.c. Answers are
// tried alone in judge_07_alone.c.
#ifndef GRADER_JUDGE_07_H
#define GRADER_JUDGE_07_H

#include "job_scene3d.h"
#include "jobs.h"
#include "judge.h"
#include "random.h"

// The checks, in the order of the report.
enum {
    CLIP_CHECK_THROUGH,
    CLIP_CHECK_INSIDE,
    CLIP_CHECK_BEHIND,
    CLIP_CHECK_PARALLEL,
    SIDE_EYE,
    SIDE_ON_PLANE,
    CHILDREN_CASES,
    CHILDREN_BEHIND,
    CHILDREN_PARALLEL,
    LEAF_NEAREST,
    LEAF_IDS,
    LEAF_ONCE,
    CHILD_ONE,
    CHILD_BOTH,
    TRACE_RANDOM,
    TRACE_PICTURE,
    WAITING_END,
    WAITING_NEXT,
    TRACE_EDGES,
    TRACE_WORK,
};

// ---- Functions --------------------------------------------------------------------------------

// How many inputs each range has; a function's ranges follow one another.
enum {
    N_CLIP_INPUTS = 500,   // 4 ranges, see ClipRange
    N_SIDE_INPUTS = 400,   // 2 ranges: the eye beside the plane, mostly on it
    N_PLANE_INPUTS = 500,  // 3 ranges: the plane ahead, behind the eye, along the ray
    N_LEAF_INPUTS = 240,   // 2 ranges: spheres of different places, some of them twice
    N_CHILD_INPUTS = 300,  // 2 ranges: where one child is met, and where both are
    N_WAITING_INPUTS = 400,
    LEAF_MAX_SPHERES = 12,
    N_LEAVES = 2 * N_LEAF_INPUTS,
    // Before and behind each leaf's ids stands one more, which must not be asked.
    N_LEAF_IDS = N_LEAVES * (LEAF_MAX_SPHERES + 2),
};

enum ClipRange { CLIP_FROM_OUTSIDE, CLIP_PART, CLIP_BESIDE, CLIP_ALONG, N_CLIP_RANGES };

typedef struct Inputs07 {
    ClipJob clips[N_CLIP_RANGES * N_CLIP_INPUTS];
    SideJob sides[2 * N_SIDE_INPUTS];
    PlaneJob planes[3 * N_PLANE_INPUTS];
    SearchJob leaves[N_LEAVES];
    u32 leaf_ids[N_LEAF_IDS];
    // As many as there are ids: who takes a position for an id finds another sphere.
    Sphere leaf_spheres[N_LEAF_IDS];
    NextChildJob children[2 * N_CHILD_INPUTS];
    NextWaitingJob waiting[N_WAITING_INPUTS];
} Inputs07;

void inputs_07_draw(Random *random, Inputs07 *inputs);

// Parts of it.
void inputs_07_draw_children(Random *random, Inputs07 *inputs);
void inputs_07_draw_waiting(Random *random, Inputs07 *inputs);

// Write all of it, a section each, of the same name. Returns 0, or -1.
int inputs_07_write(const Inputs07 *inputs, FILE *file);

// Judge a function's answers in one range. The message names the first wrong input, what was found
// and expected, and the mistake that explains every wrong answer, if one does.
Verdict inputs_07_judge_clips(const Inputs07 *inputs, int range, const Sections *answers);
Verdict inputs_07_judge_sides(const Inputs07 *inputs, int range, const Sections *answers);
Verdict inputs_07_judge_planes(const Inputs07 *inputs, int range, const Sections *answers);
Verdict inputs_07_judge_leaves(const Inputs07 *inputs, int range, const Sections *answers);

// Was every sphere of every leaf asked once?
Verdict inputs_07_judge_leaf_tests(const Inputs07 *inputs, const Sections *answers);

Verdict inputs_07_judge_children(const Inputs07 *inputs, int range, const Sections *answers);

// Does next_waiting say where the search ends; and what comes next where it does not?
Verdict inputs_07_judge_end(const Inputs07 *inputs, const Sections *answers);
Verdict inputs_07_judge_next(const Inputs07 *inputs, const Sections *answers);

// Which of next_child's inputs: by how many children the ray meets, as the stand-ins have it.
typedef enum ChildrenMet { ONE_MET = 1, BOTH_MET = 2 } ChildrenMet;

// Is next_child right alone, beside the stand-ins, wherever so many are met?
int inputs_07_pass_children(const Inputs07 *inputs, unsigned met, const Sections *answers);

// ---- Scenes -----------------------------------------------------------------------------------

// In the order of the job.
enum {
    RANDOM = 0,
    N_RANDOM = 20,
    EDGES = RANDOM + N_RANDOM,
    N_NAMED = 9,             // scenes of scene3d.h
    DEEP = EDGES + N_NAMED,  // a tree that needs the whole todo stack
    TOUCHING,                // hits on the side of the scene's box
    TIE,                     // one ray, two spheres: see draw_tie()
    N_EDGES = TIE + 1 - EDGES,
    FLAKE = EDGES + N_EDGES,
    N_SCENES,
};

// Draw the scenes, with their trees and what is expected. Returns 0, or -1 after one message.
int scenes_07_draw(Random *random, JobScene3D scenes[N_SCENES]);

// ---- The job ----------------------------------------------------------------------------------

typedef struct Job07 {
    Inputs07 inputs;
    JobScene3D scenes[N_SCENES];
    JobPicture *pictures[N_SCENES];  // the scenes'
} Job07;

// See judge, write_alone and passes_alone of judge.h.
Verdict judge_07_check(const void *job, int check, const Sections *answers);
int alone_07_write(const void *job, const char *task, FILE *file);
int alone_07_passes(const void *job, int check, const Sections *answers);

#endif
