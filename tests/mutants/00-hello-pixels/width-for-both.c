// mutant: both global sizes are computed from width
// task: enqueue_pixels
// caught by: enqueue-covers
// says: width
    const size_t local[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t groups_x = ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE;
    const size_t groups_y = ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE;
    const size_t global[2] = {groups_x * GROUP_SIZE, groups_y * GROUP_SIZE};
    (void)height;
    CL_CHECK(clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global, local, 0, NULL, NULL));
