// Probe of lab 00: a kernel that takes what set_arguments() hands over, and one that
// enqueue_pixels() launches in place of the student's, to count its work-items.
#include "jobs_00.h"

// Tell which of the three arguments of gradient() arrived.
kernel void take_arguments(int width, int height, write_only image2d_t image)
{
    write_imagef(image, (int2)(0, 0), (float4)(width, height, 0, 1));
}

// Count the work-items of each place in and around the picture, and behind them those that stand
// farther away, or in other work-groups than 16 x 16.
//   counts[side of height][side of width], and N_ITEMS_REST more
kernel void count_items(int width, int height, global uint *counts)
{
    const size_t side = PROBE_IMAGE_SIDE(width);
    const size_t rows = PROBE_IMAGE_SIDE(height);
    const size_t x = get_global_id(0);
    const size_t y = get_global_id(1);
    const int is_near = x < side && y < rows;
    global uint *rest = counts + rows * side;
    atomic_inc(is_near ? &counts[y * side + x] : &rest[ITEMS_FAR]);
    if (get_local_size(0) != 16 || get_local_size(1) != 16) {
        atomic_inc(&rest[ITEMS_IN_OTHER_GROUPS]);
        atomic_xchg(&rest[ITEMS_GROUP_WIDTH], (uint)get_local_size(0));
        atomic_xchg(&rest[ITEMS_GROUP_HEIGHT], (uint)get_local_size(1));
    }
}
