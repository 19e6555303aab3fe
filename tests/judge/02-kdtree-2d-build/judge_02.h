// What lab 02's judge asks of a submission: inputs of its functions and scenes for its trees.
// Rolled in judge_02_job.c and judge_02_inputs.c; functions are judged in judge_02_functions.c,
// judge_02_overlap.c and judge_02_lists.c, whole trees in tree_judge.c; one answer alone in
// judge_02_alone.c.
#ifndef JUDGE_JUDGE_02_H
#define JUDGE_JUDGE_02_H

#include "job_scene.h"
#include "jobs_02.h"
#include "judge.h"

// Inputs of is_leaf are by turns about the level, the number of circles and failed splits; those of
// circle_overlaps_box are in three ranges. The last of each are the same with every seed.
enum { N_LEAVES = 660, N_SPLITS = 414, N_DISTRIBUTES = 65, N_PACKS = 66 };
enum { N_INSIDE = 1012, N_BOUNDARY = 523, N_CORNER = 509 };
enum { N_OVERLAPS = N_INSIDE + N_BOUNDARY + N_CORNER };

// The scenes: those of roll_scenes(), DISTRIBUTE_SCENE, and one whose lists 16 bits cannot count.
enum { PILE = DISTRIBUTE_SCENE + 1, N_SCENES };

typedef struct Job02 {
    Job job;
    LeafJob leaves[N_LEAVES];
    BBox2D splits[N_SPLITS];
    BoxOverlapJob overlaps[N_OVERLAPS];
    DistributeJob distributes[N_DISTRIBUTES];
    PackJob packs[N_PACKS];
    JobScene scenes[N_SCENES];
} Job02;

// See judge.h.
int roll_job_02(void *job, Random *random);
int job_02_write_scene(const void *job, int k, FILE *file);

// Roll the inputs of the functions; the scenes are rolled already.
void roll_inputs_02(Random *random, Job02 *job);

// The functions; of split_box and pack_leaf one for each property that is judged.
extern const Function is_leaf_02, split_longer_02, split_middle_02, overlap_02, distribute_02,
    pack_count_02, pack_offset_02, pack_rest_02;

// Of an answer that is neither 1 nor 0, and means the right one.
#define JUST_1_AND_0 "right but for its value: the answers are 1 and 0"

// Call number i of distribute.
ListCall list_call_02(const Job02 *job, int i);

// One answer alone.
extern const Replay replay_leaf_02, replay_split_02, replay_overlap_02;
int write_alone_02(const void *job, const char *task, FILE *file);
int distributes_alone_02(const void *job, const JudgeCheck *check, const Sections *answers);
int lists_alone_02(const void *job, const JudgeCheck *check, const Sections *answers);
int packs_alone_02(const void *job, int k, const Sections *answers);

#endif
