// What the bench tells: tables for people, a CSV file for the plot.
#ifndef BENCH_REPORT_H
#define BENCH_REPORT_H

#include "case2d.h"

// Print all tables. `cases` holds the fill, and the naive one and the kd-tree of usual limits
// for each scene, the lecture's 8192 circles among them.
void report_print(const Case2D *cases, int n_cases, const char *device_name);

// Write FOLDER/bench2d.csv, one row a case: variant,n_circles,max_depth,leaf_size,median_ms,
// min_ms,max_ms,fps; a variant "tiles 2 to 20 px" is of radii in pixels. The naive rows and then
// the kd-tree rows of usual limits come first, each from few circles to many; fields that mean
// nothing are empty. Returns 0, or -1 after one message.
int report_write_csv(const Case2D *cases, int n_cases, const char *folder);

#endif
