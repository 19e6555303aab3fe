// mutant: groups of 256 x 1: as many work-items, but not what was asked for
// task: enqueue_pixels
// caught by: enqueue-covers
// says: 256 x 1.*GROUP_SIZE
    const size_t local_size[2] = {GROUP_SIZE * GROUP_SIZE, 1};
    const size_t global_size[2] = {
        ((size_t)width + local_size[0] - 1) / local_size[0] * local_size[0],
        (size_t)height,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
