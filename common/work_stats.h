// The counters of kernels/work.h on the host: a buffer for them, their mean and maximum as figures,
// and pictures of them.
//
// Read next: kernels/work.h.
#ifndef COMMON_WORK_STATS_H
#define COMMON_WORK_STATS_H

#include "cl_setup.h"
#include "stats.h"
#include "work.h"

// What the counters count; the kinds differ in the figures' names and in how many there are.
typedef enum WorkKind {
    WORK_CIRCLES,         // circle_tests, nodes_visited
    WORK_SPHERES,         // sphere_tests, nodes_visited, leaves_visited, stack_depth
    WORK_SPHERES_MIDDLE,  // lab 08, of lab 06's tree: the same as middle.sphere_tests, ...
} WorkKind;

// A device buffer of width * height Work and some room behind them, zeroed. Release with
// clReleaseMemObject. Here and below, running out of memory ends the program with a message.
cl_mem work_buffer_create(const ClSetup *cl, int width, int height);

// All steps of one pixel, of whatever kind: what a heat map shows.
u32 work_steps(const Work *work);

// Read the counters back, and add NAME.mean_per_pixel and NAME.max_per_pixel of each to the
// figures.
//   picture_path   NULL, or the path of the run's picture, "a.png": then each pixel's work is saved
//                  beside it: as "a-work.exr", tests in red, nodes in green, leaves in blue, stack
//                  depth in alpha, and as a heat map for people, "a-work.png": tests, nodes and
//                  leaves together, from black for none to the brightest colour for the most, which
//                  becomes the figure heat_map.brightest. Of WORK_SPHERES_MIDDLE they are called
//                  "a-middle-work.exr" and "a-middle-work.png"
// Returns 0, or -1 after one message on stderr.
int work_report(const ClSetup *cl, cl_mem d_work, int width, int height, WorkKind kind,
                const char *picture_path, Stats *stats);

#endif
