// What lab 06's judge asks of a submission: inputs of its functions and scenes for its trees.
// Rolled in judge_06_job.c; functions are judged in judge_06_functions.c, judge_06_overlap.c and
// judge_06_packs.c, trees in tree3d_judge.c; one answer alone in judge_06_alone.c.
#ifndef JUDGE_JUDGE_06_H
#define JUDGE_JUDGE_06_H

#include "jobs_06.h"
#include "judge.h"
#include "tree3d_judge.h"

// Inputs of sphere_overlaps_box are in three ranges. The last of each kind are the same with every
// seed.
enum { N_SPLITS = 489, N_PACKS = 66 };
enum { N_INSIDE = 1010, N_TOUCHING = 607, N_CORNER = 607 };
enum { N_OVERLAPS = N_INSIDE + N_TOUCHING + N_CORNER };

// Levels: each from 1 to N_LEVELS_IN_ORDER, then those around powers of two, then any.
enum { N_LEVELS_IN_ORDER = 1100, N_POWERS = 15, N_AROUND = 5, N_ANY_LEVELS = 25 };
enum { N_LEVELS = N_LEVELS_IN_ORDER + N_POWERS * N_AROUND + N_ANY_LEVELS };

// Scenes: those whose trees are judged in all respects, then two about the todo stack: one whose
// tree just fits it, and one that must be refused.
enum { N_TREES = 10, JUST_FITS = N_TREES, TOO_DEEP, N_SCENES };

typedef struct Job06 {
    Job job;  // with the trees of all scenes but TOO_DEEP
    BBox3D splits[N_SPLITS];
    SphereBoxJob overlaps[N_OVERLAPS];
    PackJob packs[N_PACKS];
    LevelJob levels[N_LEVELS];
    TreeScene3D scenes[N_SCENES];
    Growth too_deep;  // the tree that must be refused, as it would be
} Job06;

// See judge.h.
int roll_job_06(void *job, Random *random);
void job_06_release(void *job);

// The functions; of choose_split and pack_leaf_range one for each property that is judged.
extern const Function split_axis_06, split_middle_06, overlap_06, pack_node_06, pack_ids_06,
    fits_06;

// One answer alone.
extern const Replay replay_split_06, replay_overlap_06;
int write_alone_06(const void *job, const char *task, FILE *file);
int packs_alone_06(const void *job, int k, const Sections *answers);
int levels_alone_06(const void *job, const JudgeCheck *check, const Sections *answers);

#endif
