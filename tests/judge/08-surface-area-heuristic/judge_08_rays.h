// What a search through a kd-tree costs, counted: the oracle's, ray by ray.
#ifndef JUDGE_JUDGE_08_RAYS_H
#define JUDGE_JUDGE_08_RAYS_H

#include "scene3d.h"
#include "tree3d.h"

// Means a ray.
typedef struct SearchWork {
    double n_tests;
    double n_nodes;  // inner nodes
} SearchWork;

// Trace the scene's view in few pixels through the tree: near child first, and no further than to
// the first hit. Ids and ranges of the tree must be sound (tree3d_judge_packing()), and its depth.
SearchWork search_work_08(const Scene3D *scene, const KdTree3D *tree);

#endif
