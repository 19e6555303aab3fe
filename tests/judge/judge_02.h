// What lab 02's judge asks of a submission: inputs of its functions and scenes for its trees.
// Drawn in judge_02_job.c, judged in judge_02.c and judge_02_functions.c; one answer alone in
// judge_02_alone.c.
#ifndef GRADER_JUDGE_02_H
#define GRADER_JUDGE_02_H

#include "job_scene.h"
#include "jobs.h"
#include "judge.h"
#include "replay.h"

#include <stdint.h>
#include <stdio.h>

// The checks.
enum {
    IS_LEAF_DEPTH,
    IS_LEAF_COUNT,
    IS_LEAF_FAILED,
    TREE_LIMITS,
    SPLIT_LONGER,
    SPLIT_MIDDLE,
    TREE_CELLS,
    OVERLAP_INSIDE,
    OVERLAP_BOUNDARY,
    OVERLAP_CORNER,
    TREE_OVERLAP,
    DISTRIBUTE_LIST,
    TREE_LISTS,
    PACK_COUNT,
    PACK_OFFSET,
    PACK_REST,
    TREE_PACKING,
};

enum { N_LEAVES = 600, N_SPLITS = 400, N_DISTRIBUTES = 60, N_PACKS = 60, N_SCENES = 7 };
// Inputs of circle_overlaps_box: a range for each check.
enum { N_INSIDE = 1000, N_BOUNDARY = 500, N_CORNER = 500 };
enum { N_OVERLAPS = N_INSIDE + N_BOUNDARY + N_CORNER };

typedef struct Job02 {
    LeafJob leaves[N_LEAVES];
    BBox2D splits[N_SPLITS];
    BoxOverlapJob overlaps[N_OVERLAPS];
    DistributeJob distributes[N_DISTRIBUTES];
    PackJob packs[N_PACKS];
    JobScene scenes[N_SCENES];
    Replay replay;  // of their trees
} Job02;

// See job_new and job_free of judge.h.
void *job_02_new(uint64_t seed, FILE *file);
void job_02_free(void *job);

// Judge a function by the answers.
//   first, n   the inputs that the check is about; of the leaves every third from the first
//   check      which of the function's properties is judged
Verdict judge_02_is_leaf(const Job02 *job, int first, const Sections *answers);
Verdict judge_02_split(const Job02 *job, int check, const Sections *answers);
Verdict judge_02_overlaps(const Job02 *job, int first, int n, const Sections *answers);
Verdict judge_02_distribute(const Job02 *job, const Sections *answers);
Verdict judge_02_pack(const Job02 *job, int check, const Sections *answers);

// See write_alone of judge.h.
int judge_02_write_alone(const void *job, const char *task, FILE *file);

// passes_alone of judge.h for the checks that are judged otherwise than in the whole: all of whole
// trees, and of distribute.
int judge_02_passes_alone(const Job02 *job, int check, const Sections *answers);

#endif
