// The tree of a job's 3D scene, built with the solution of lab 06. For the judges of later labs: a
// handout of lab 06 or before does not contain that solution.
#ifndef JUDGE_JOB_SCENE3D_TREE_H
#define JUDGE_JOB_SCENE3D_TREE_H

#include "job_scene3d.h"

// Build it. Returns 0, or -1 after one message.
int job_scene3d_grow_tree(JobScene3D *scene, KdTreeLimits limits);

#endif
