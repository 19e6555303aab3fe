// The counters of kernels/work.h on the host: a buffer for them, and their mean and maximum.
//
// Flow: scene -> BUFFERS -> KERNEL -> image -> comparison. Read next: kernels/work.h.
#ifndef COMMON_WORK_STATS_H
#define COMMON_WORK_STATS_H

#include "cl_setup.h"
#include "stats.h"

// A device buffer of width * height Work and some room behind them, zeroed. Release with
// clReleaseMemObject.
cl_mem work_buffer_create(const ClSetup *cl, int width, int height);

// Read the counters back and add circle_tests.mean_per_pixel, circle_tests.max_per_pixel,
// nodes_visited.mean_per_pixel and nodes_visited.max_per_pixel to the figures.
void work_stats_add(const ClSetup *cl, cl_mem d_work, int width, int height, Stats *stats);

#endif
