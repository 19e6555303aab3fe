// What the 3D bench tells of shadow and mirrored rays: a table for people, a CSV file.
//
// Read next: report_secondary.c.
#ifndef BENCH_REPORT_SECONDARY_H
#define BENCH_REPORT_SECONDARY_H

#include "report3d.h"
#include "secondary_rays.h"

// What tables and messages call the rays ("shadow") and what searches them ("rtcOccluded8"); NULL
// where it does not search such rays.
extern const char *const RAY_KIND_NAMES[N_RAY_KINDS];
extern const char *const SEARCHER_TITLES[N_RAY_KINDS][N_SEARCHERS];

// Print all tables.
//   scene_name   whose rays they are
void report_secondary_print(const SecondaryRays *secondary, const char *scene_name,
                            ReportContext context);

// Write FOLDER/bench3d-secondary.csv, one row a kind of rays and a searcher; fields that mean
// nothing are empty:
//     rays, scene          shadow or mirrored, and as --scene takes it
//     searcher             kdtree, tiles; embree1, 4, 8, 16 and 1M
//     n_rays
//     median_ms, min_ms, max_ms, mray_s    of all rays; million rays a second at the median
//     different_answers    from those of the kd-tree
//     is_best              1: of Embree's calls the one with the smallest median; else 0
// Returns 0, or -1 after one message.
int report_secondary_write_csv(const SecondaryRays *secondary, const char *scene_name,
                               const char *folder);

#endif
