// fault: a barrier behind a guard: the work-items outside the picture never reach it
// lab: 01-naive-2d
// task: own_pixel
// says: not all work-items of a group get to this barrier
    const int x = get_global_id(0);
    const int y = get_global_id(1);
    if (x >= width || y >= height) {
        return;
    }
    barrier(CLK_LOCAL_MEM_FENCE);  // HERE
