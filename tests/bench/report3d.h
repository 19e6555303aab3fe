// What the 3D bench tells: tables for people, a CSV file for the plot.
//
// Read next: report_trees.h, report_moving.h, report_secondary.h.
#ifndef BENCH_REPORT3D_H
#define BENCH_REPORT3D_H

#include "case3d.h"

// What tables and messages call the renderers: "kd-tree (lab 07)", "rtcIntersect8".
extern const char *const RENDERER3D_TITLES[N_RENDERERS];

// What was measured with.
typedef struct ReportContext {
    const char *device_name;
    int device_is_cpu;
    int n_threads;  // of Embree; 0 when it took no part
} ReportContext;

// Is this one of the scenes that stand in every table?
int report3d_compares(const Case3D *bench_case);

// Print the ratio of two series' times: the median of the single rounds' ratios, and their spread.
void report3d_print_ratio(const Series *dividend, const Series *divisor);

// Print all tables.
void report3d_print(const Case3D *cases, int n_cases, ReportContext context);

// Write FOLDER/bench3d.csv, one row a scene and renderer; fields that mean nothing are empty:
//     renderer             naive, kdtree, bycost, tiles; embree1, 4, 8, 16 and 1M
//     scene, n_spheres     as --scene takes it
//     median_ms, min_ms, max_ms, mray_s    a frame; million rays a second at the median
//     share                of the picture that was drawn
//     build_median_ms, build_min_ms, build_max_ms    of the tree, on one thread
//     build_parallel_ms    with all of Embree's threads, median; not of the tiles'
//     n_nodes, n_leaves, n_sphere_ids, depth
//     nodes_a_ray, leaves_a_ray, tests_a_ray
//     different_pixels     of the kd-tree's picture from this renderer's
//     is_best              1: of Embree's calls the one with the smallest median; else 0
// Returns 0, or -1 after one message.
int report3d_write_csv(const Case3D *cases, int n_cases, const char *folder);

#endif
