// What a ray of lab 07's kernel reads and computes on its way through the tree, and what that makes
// a second: to be held against what a device can read and compute at most (its roofline).
#ifndef BENCH_ROOFLINE_H
#define BENCH_ROOFLINE_H

#include "case3d.h"

// Print a table, a line a scene.
void roofline_print(const Case3D *cases, int n_cases);

#endif
