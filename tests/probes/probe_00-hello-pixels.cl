// Probe of lab 00: a kernel that is launched in the student's stead by enqueue_pixels(), to count
// its work-items.
#include "jobs.h"

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
