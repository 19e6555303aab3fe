// How much work a right search through a scene's kd-tree does, in double precision and
// independently of lab 07.
#ifndef JUDGE_JUDGE_07_WORK_H
#define JUDGE_JUDGE_07_WORK_H

#include "job_scene3d.h"
#include "work.h"

// Between these the work of a right search lies.
typedef struct WorkBounds {
    Work least;  // its leaves are those with spheres: nobody need search an empty one
    Work most;
} WorkBounds;

// The least and the most work that a right solution may do for this ray, whichever way float
// rounds. A solution that asks each sphere of a leaf once, and ends as early as it must, never does
// more; one that does less has not looked where a sphere may be, or hides what it does. No least
// stack depth is known.
WorkBounds search3d_bounds(const JobScene3D *scene, const OracleRay *ray);

// May a right search for this ray ask the sphere?
int search3d_may_ask(const JobScene3D *scene, const OracleRay *ray, u32 sphere);

#endif
