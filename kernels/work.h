// Counting work: how many circles or spheres a pixel asks, how many nodes it visits.
//
// Milliseconds differ from machine to machine; counts do not. A kernel writes WORK_PARAMETER after
// its last parameter, WORK_BEGIN after the guard by which work-items outside the picture leave, and
// WORK_END, which uses the kernel's parameter `width`, as its last statement. A function that
// counts for it takes WORK_POINTER after its last parameter, and gets WORK_ARGUMENT after its last
// argument. WORK_COUNT(n_nodes_visited) counts one more of them, WORK_MOST(stack_depth, n) keeps
// the largest n; calls are counted from where count_circle_search.h or count_sphere_tests.h is
// included. Built without -DCOUNT_WORK all of this is empty and costs nothing.
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: common/work_stats.h.
#ifndef KERNELS_WORK_H
#define KERNELS_WORK_H

#include "layout.h"

// What one pixel cost. The buffer holds width * height of them, row by row.
typedef struct Work {
    /*  0 */ u32 n_tests;           // calls of overlaps_N_Nearer or intersect_sphere
    /*  4 */ u32 n_nodes_visited;   // inner nodes: calls of getContainingChild or next_child
    /*  8 */ u32 n_leaves_visited;  // 3D: calls of search_leaf
    /* 12 */ u32 stack_depth;       // 3D: most nodes that waited on the todo stack at once
} Work;
LAYOUT_ASSERT(Work, 16);

#ifdef __OPENCL_C_VERSION__
#ifdef COUNT_WORK
#define WORK_PARAMETER , global Work *d_work
// A function whose task is still to be solved does not use it yet.
#define WORK_POINTER , Work *work __attribute__((unused))
#define WORK_ARGUMENT , work
#define WORK_COUNT(field) work->field++
#define WORK_MOST(field, n) work->field = max(work->field, n)
#define WORK_BEGIN                                                                                 \
    Work pixel_work = {0, 0, 0, 0};                                                                \
    Work *const work __attribute__((unused)) = &pixel_work
#define WORK_END(x, y) d_work[(y) * width + (x)] = pixel_work
#else
#define WORK_PARAMETER
#define WORK_POINTER
#define WORK_ARGUMENT
#define WORK_COUNT(field)
#define WORK_MOST(field, n)
#define WORK_BEGIN
#define WORK_END(x, y)
#endif
#endif

#endif
