// The tree of a job's scene, built with the solution of lab 02. For the judges of later labs: a
// handout of lab 02 or before does not contain that solution.
#ifndef JUDGE_JOB_SCENE_TREE_H
#define JUDGE_JOB_SCENE_TREE_H

#include "job_scene.h"

// Build it. Returns 0, or -1 after one message.
int job_scene_grow_tree(JobScene *scene, KdTreeLimits limits);

#endif
