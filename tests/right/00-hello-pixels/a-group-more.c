// right: always one group more, which is wasteful and legal
// task: enqueue_pixels
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {((size_t)width / GROUP_SIZE + 1) * GROUP_SIZE,
                                   ((size_t)height / GROUP_SIZE + 1) * GROUP_SIZE};
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
