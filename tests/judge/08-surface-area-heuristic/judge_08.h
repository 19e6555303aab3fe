// What lab 08's judge asks of a submission: inputs of its functions and scenes for its trees.
// Rolled in judge_08_job.c; functions are judged in judge_08_area.c, judge_08_functions.c and
// judge_08_best.c, whole trees in judge_08_trees.c.
#ifndef JUDGE_JUDGE_08_H
#define JUDGE_JUDGE_08_H

#include "judge.h"
#include "sah_oracle.h"
#include "tree3d_judge.h"

// Inputs of the functions, each in the ranges of its checks. The last of a range are the same with
// every seed; the first of areas and costs are what the building of the trees sends.
enum { N_SENT = 200 };
enum { N_BOXES = N_SENT + 200, N_FLAT = 60, N_AREAS = N_BOXES + N_FLAT };
enum { N_PLANES = N_SENT + 300, N_COST_EDGES = 100, N_COSTS = N_PLANES + N_COST_EDGES };
enum { N_CELLS = 120, N_TIES = 36, N_CELL_EDGES = 70, N_BESTS = N_CELLS + N_TIES + N_CELL_EDGES };
enum { N_BY_COST = 300, N_BY_LIMITS = 200, N_DECISIONS = N_BY_COST + N_BY_LIMITS };

// The most spheres of a node among the inputs of find_best_split; the last one has more. Between
// them stand others, which its ids leave out.
enum { MOST_IDS = 120, MANY_NODE = N_BESTS - 1, N_MANY_IDS = (1 << 16) + 300 };
enum { N_BEST_IDS = MANY_NODE * MOST_IDS + N_MANY_IDS, N_BEST_SPHERES = 2 * N_BEST_IDS };

enum { N_TREES = 11 };

typedef struct Job08 {
    Job job;
    BBox3D areas[N_AREAS];
    CostJob costs[N_COSTS];
    BestJob bests[N_BESTS];
    Sphere best_spheres[N_BEST_SPHERES];
    u32 best_ids[N_BEST_IDS];
    LeafCostJob decisions[N_DECISIONS];
    TreeScene3D scenes[N_TREES];  // their trees are the oracle's
} Job08;

// See judge.h.
int roll_job_08(void *job, Random *random);
int roll_scenes_08(Random *random, Job08 *job);  // and the expected trees; 0, or -1 after a message
void add_sent_08(Random *random, Job08 *job);

// The functions.
extern const Function area_08, cost_08, best_08, decision_08;

// Do the answers of one task alone stand, by what is asked of it or by what stands in the other
// tasks' places? (tests/stubs)
int costs_alone_08(const void *job, const JudgeCheck *check, const Sections *answers);
int bests_alone_08(const void *job, const JudgeCheck *check, const Sections *answers);

// ---- Whole trees (judge_08_trees.c) -------------------------------------------------------------

// Grow scene->tree by the contract, from the oracle's costs. Returns 0, or -1 after one message.
int tree_expect_08(TreeScene3D *scene);

// Each plane is a candidate of its cell, and none of them costs less.
Diagnosis tree_judge_splits_08(const TreeScene3D *scene, const KdTree3D *own);

// Leaves are where a limit or the cost says so, and nowhere else.
Diagnosis tree_judge_leaves_08(const TreeScene3D *scene, const KdTree3D *own);

// A search through the tree does not take much more work than through the expected one.
Diagnosis tree_judge_work_08(const TreeScene3D *scene, const KdTree3D *own);

#endif
