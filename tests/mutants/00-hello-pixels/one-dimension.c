// mutant: a launch of one dimension
// task: enqueue_pixels
// caught by: enqueue-covers
// says: one row of work-items
// looks: unwritten
    const size_t local_size[1] = {GROUP_SIZE};
    const size_t global_size[1] = {
        ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
    };
    (void)height;
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 1, NULL, global_size, local_size, 0, NULL, NULL));
