// Counting work: how many circles or spheres a pixel tests, how many nodes it visits.
//
// Milliseconds differ from machine to machine; counts do not. Functions that count take a pixel's
// `work` as their last parameter, and pass it on to those that they call. Whether anything is
// counted is fixed when a kernel is built: without -DCOUNT_WORK the functions below are empty, and
// a compiler leaves `work` out.
// Flow: scene -> buffers -> KERNEL -> image. Read next: common/work_stats.h.
#ifndef KERNELS_WORK_H
#define KERNELS_WORK_H

#include "layout.h"

// What one pixel cost. The buffer holds width * height of them, row by row.
typedef struct Work {
    /*  0 */ u32 n_tests;           // calls of overlaps_N_Nearer or intersect_sphere
    /*  4 */ u32 n_nodes_visited;   // inner nodes at which a child was chosen: steps; no leaves
    /*  8 */ u32 n_leaves_visited;  // 3D: leaves that were searched
    /* 12 */ u32 stack_depth;       // 3D: most nodes that waited on the todo stack at once
} Work;
LAYOUT_ASSERT(Work, 16);

#ifdef __OPENCL_C_VERSION__

#ifdef COUNT_WORK
#define IS_COUNTING 1
#else
#define IS_COUNTING 0
#endif

// A circle or a sphere is tested.
static inline void count_test(Work *work)
{
    if (IS_COUNTING) {
        work->n_tests++;
    }
}

// A child of an inner node is chosen.
static inline void count_node(Work *work)
{
    if (IS_COUNTING) {
        work->n_nodes_visited++;
    }
}

// A leaf is searched.
static inline void count_leaf(Work *work)
{
    if (IS_COUNTING) {
        work->n_leaves_visited++;
    }
}

// This many nodes wait on the todo stack.
static inline void count_waiting(Work *work, uint n_waiting)
{
    if (IS_COUNTING) {
        work->stack_depth = max(work->stack_depth, n_waiting);
    }
}

// Write down what a pixel cost.
//   d_work   the buffer; NULL where nothing is counted
static inline void work_save(Work work, int x, int y, int width, global Work *d_work)
{
    if (IS_COUNTING) {
        d_work[y * width + x] = work;
    }
}

#endif

#endif
