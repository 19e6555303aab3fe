// mutant: groups of 8 x 8: as fast, but not what was asked for
// task: enqueue_pixels
// caught by: enqueue-covers
// says: 8 x 8.*GROUP_SIZE
    const size_t local_size[2] = {8, 8};
    const size_t global_size[2] = {
        ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
        ((size_t)height + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
