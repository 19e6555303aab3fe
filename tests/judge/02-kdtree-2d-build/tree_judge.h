// Judging a student's 2D kd-tree by its invariants, and against the oracle's tree.
//
// Each function looks at one property and returns NOTHING_WRONG when it holds, else what is wrong,
// owned by the caller. The arrays are a submission's: every id, offset and count is checked before
// it is used.
#ifndef JUDGE_TREE_JUDGE_H
#define JUDGE_TREE_JUDGE_H

#include "job_scene.h"

// Leaves where the limits say so, and nowhere else.
Diagnosis tree_judge_limits(const JobScene *scene, const KdTree2D *own);

// Each inner node's two children tile it as the lecture says.
Diagnosis tree_judge_cells(const JobScene *scene, const KdTree2D *own);

// Each leaf lists exactly the circles that overlap its cell.
Diagnosis tree_judge_overlap(const JobScene *scene, const KdTree2D *own);

// Each list is ascending and names no circle twice.
Diagnosis tree_judge_lists(const JobScene *scene, const KdTree2D *own);

// Ids are positions, breadth-first without gaps; lists ascend, follow one another and fill the map.
Diagnosis tree_judge_packing(const JobScene *scene, const KdTree2D *own);

// The probe's answer for scene K as a tree that points into the answers (do not free it). Returns
// 1, or 0 when it is missing or its arrays do not fit together.
int tree_judge_answer(int k, const Sections *answers, KdTree2D *own);

#endif
