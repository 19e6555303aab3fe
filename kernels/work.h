// Counting work: how many circles a pixel asks and how many nodes it visits.
//
// Milliseconds differ from machine to machine; counts do not. A renderer writes WORK_PARAMETER
// after its last parameter, WORK_BEGIN after the guard by which work-items outside the picture
// leave, and WORK_END, which uses the renderer's parameter `width`, as its last statement. It
// includes count_calls.h after the functions whose calls are to be counted. Built without
// -DCOUNT_WORK all of this is empty and costs nothing.
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: common/work_stats.h.
#ifndef KERNELS_WORK_H
#define KERNELS_WORK_H

#include "layout.h"

// What one pixel cost. The buffer holds width * height of them, row by row.
typedef struct Work {
    /* 0 */ u32 n_circle_tests;   // calls of overlaps_N_Nearer
    /* 4 */ u32 n_nodes_visited;  // calls of getContainingChild
} Work;
LAYOUT_ASSERT(Work, 8);

#ifdef __OPENCL_C_VERSION__
#ifdef COUNT_WORK
#define WORK_PARAMETER , global Work *d_work
#define WORK_BEGIN Work work = {0, 0}
#define WORK_END(x, y) d_work[(y) * width + (x)] = work
#else
#define WORK_PARAMETER
#define WORK_BEGIN
#define WORK_END(x, y)
#endif
#endif

#endif
