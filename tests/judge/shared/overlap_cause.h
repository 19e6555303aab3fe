// What one mistake explains all wrong answers to "does a circle, or a sphere, overlap a cell?"
// (labs 02 and 06).
#ifndef JUDGE_OVERLAP_CAUSE_H
#define JUDGE_OVERLAP_CAUSE_H

#include "diagnosis.h"
#include "layout.h"

// One input: how far the centre lies outside of the cell on each axis, 0 where it does not, and how
// far the circle or sphere reaches.
typedef struct Reach {
    double outside[3];  // in 2D z is 0
    double radius;      // as it is given: it may be negative in 3D
} Reach;

// Input number i of the job.
typedef Reach ReachOf(const void *job, int i);

// How far a coordinate lies outside of [min, max].
double outside_of(double coordinate, double min, double max);

// What the wrong answers look like, of which there is one at least; no cause where no known mistake
// explains them all. Every input is such that double decides it exactly.
//   found[n]   the answers to all inputs of the job
Cause overlap_cause(ReachOf *reach_of, const void *job, int n, const i32 *found);

// Are the answers those about the square around the circle, or the cube around the sphere?
int overlap_is_of_box(ReachOf *reach_of, const void *job, int n, const i32 *found);

#endif
