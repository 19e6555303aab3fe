// What lab 06's judge asks of a submission: inputs of its functions and scenes for its trees.
// Drawn in judge_06_job.c, judged in judge_06.c and judge_06_functions.c; one answer alone in
// judge_06_alone.c.
#ifndef GRADER_JUDGE_06_H
#define GRADER_JUDGE_06_H

#include "jobs.h"
#include "judge.h"
#include "replay.h"
#include "tree3d_judge.h"

#include <stdint.h>
#include <stdio.h>

// The checks.
enum {
    SPLIT_AXIS,
    SPLIT_MIDDLE,
    TREE_SPLITS,
    OVERLAP_INSIDE,
    OVERLAP_TOUCHING,
    OVERLAP_CORNER,
    TREE_OVERLAP,
    PACK_NODE,
    PACK_IDS,
    TREE_PACKING,
    FITS_LEVELS,
    TREE_DEPTH,
};

enum { N_SPLITS = 480, N_PACKS = 60 };
// Inputs of sphere_overlaps_box: a range for each check.
enum { N_INSIDE = 1000, N_TOUCHING = 600, N_CORNER = 600 };
enum { N_OVERLAPS = N_INSIDE + N_TOUCHING + N_CORNER };
// Scenes: those whose trees are judged in all respects, then two about the todo stack: one whose
// tree just fits it, and one that must be refused.
enum { N_TREES = 10, JUST_FITS = N_TREES, TOO_DEEP, N_SCENES };

typedef struct Job06 {
    BBox3D splits[N_SPLITS];
    SphereBoxJob overlaps[N_OVERLAPS];
    PackJob3D packs[N_PACKS];
    TreeScene3D scenes[N_SCENES];
    Replay replay;    // of the trees of all scenes but TOO_DEEP
    Replay too_deep;  // of the tree that must be refused, as it would be
} Job06;

// See job_new and job_free of judge.h.
void *job_06_new(uint64_t seed, FILE *file);
void job_06_free(void *job);

// Judge a function by the answers.
//   first, n   the inputs that the check is about
//   check      which of the function's two properties is judged
Verdict judge_06_splits(const Job06 *job, int check, const Sections *answers);
Verdict judge_06_overlaps(const Job06 *job, int first, int n, const Sections *answers);
Verdict judge_06_pack(const Job06 *job, int check, const Sections *answers);
Verdict judge_06_fits(const Sections *answers);

// Write "todo". Returns 0, or -1.
int job_06_write_levels(FILE *file);

// See write_alone of judge.h.
int judge_06_write_alone(const void *job, const char *task, FILE *file);

// passes_alone of judge.h for the checks of whole trees, which are judged otherwise than in the
// whole.
int judge_06_passes_alone(const Job06 *job, int check, const Sections *answers);

#endif
