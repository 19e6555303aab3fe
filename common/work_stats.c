// Reading the work counters back (see work_stats.h); what they count is told in kernels/work.h.
//
// Flow: scene -> BUFFERS -> KERNEL -> image -> comparison: a buffer beside the picture, for the
// figures. Read next: stats.c.
#include "work_stats.h"

#include "work.h"

#include <stdio.h>
#include <stdlib.h>

// Work-items that fill up the last work-groups write nothing; should a student's do, it stays
// inside.
enum { GROUP_MARGIN = 64 };

static Work *work_allocate(size_t n_pixels)
{
    Work *h_work = calloc(n_pixels, sizeof *h_work);
    if (h_work == NULL) {
        fprintf(stderr, "work_stats: no memory for the counters of %zu pixels\n", n_pixels);
        exit(EXIT_FAILURE);
    }
    return h_work;
}

cl_mem work_buffer_create(const ClSetup *cl, int width, int height)
{
    const size_t n_pixels = ((size_t)width + GROUP_MARGIN) * ((size_t)height + GROUP_MARGIN);
    Work *h_zeros = work_allocate(n_pixels);
    cl_int error;
    cl_mem d_work = clCreateBuffer(cl->context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                                   n_pixels * sizeof *h_zeros, h_zeros, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    free(h_zeros);
    return d_work;
}

void work_stats_add(const ClSetup *cl, cl_mem d_work, int width, int height, Stats *stats)
{
    const size_t n_pixels = (size_t)width * (size_t)height;
    Work *h_work = work_allocate(n_pixels);
    CL_CHECK(clEnqueueReadBuffer(cl->queue, d_work, CL_TRUE, 0, n_pixels * sizeof *h_work, h_work,
                                 0, NULL, NULL));
    double sum_tests = 0, sum_nodes = 0;
    u32 max_tests = 0, max_nodes = 0;
    for (size_t i = 0; i < n_pixels; i++) {
        sum_tests += h_work[i].n_circle_tests;
        sum_nodes += h_work[i].n_nodes_visited;
        max_tests = h_work[i].n_circle_tests > max_tests ? h_work[i].n_circle_tests : max_tests;
        max_nodes = h_work[i].n_nodes_visited > max_nodes ? h_work[i].n_nodes_visited : max_nodes;
    }
    free(h_work);
    stats_number(stats, "circle_tests.mean_per_pixel", sum_tests / (double)n_pixels);
    stats_integer(stats, "circle_tests.max_per_pixel", max_tests);
    stats_number(stats, "nodes_visited.mean_per_pixel", sum_nodes / (double)n_pixels);
    stats_integer(stats, "nodes_visited.max_per_pixel", max_nodes);
}
