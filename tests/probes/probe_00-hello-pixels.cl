// Probe of lab 00: a kernel that takes what set_arguments() hands over, and one that
// enqueue_pixels() launches in place of the student's, to count its work-items.
#include "jobs.h"

// Use the three arguments of gradient() once.
kernel void take_arguments(int width, int height, write_only image2d_t image)
{
    write_imagef(image, (int2)(0, 0), (float4)(width, height, 0, 1));
}

// Count the work-items of each place in and around the picture, and behind them all that stand
// farther away.
//   counts[side of height][side of width], and one more
kernel void count_items(int width, int height, global uint *counts)
{
    const size_t side = PROBE_IMAGE_SIDE(width);
    const size_t rows = PROBE_IMAGE_SIDE(height);
    const size_t x = get_global_id(0);
    const size_t y = get_global_id(1);
    const int is_near = x < side && y < rows;
    atomic_inc(&counts[is_near ? y * side + x : rows * side]);
}
