// What the 3D bench tells of scenes that move: their trees are built anew for each frame. From how
// many spheres on does that pay against the naive kernel, which has no tree? And from how many on
// does building alone take longer than a frame may?
//
// Read next: bench3d-moving.gnuplot.
#ifndef BENCH_REPORT_MOVING_H
#define BENCH_REPORT_MOVING_H

#include "case3d.h"

// Print the tables and the crossings. The random scenes among the cases count, which come from few
// spheres to many.
void report_moving_print(const Case3D *cases, int n_cases);

// Write FOLDER/bench3d-moving.csv, one row a random scene and renderer; fields that mean nothing
// are empty:
//     renderer, n_spheres              naive, kdtree, bycost, tiles
//     build_ms, copy_ms, draw_ms       of a frame: the tree, to the device, the picture; medians
//     median_ms, min_ms, max_ms        of all three, from round to round
//     ratio, min_ratio, max_ratio      of the naive frame to that
// Returns 0, or -1 after one message.
int report_moving_write_csv(const Case3D *cases, int n_cases, const char *folder);

#endif
