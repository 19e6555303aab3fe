// mutant: rounded up, but multiplied where it should be divided: far too many work-items
// task: enqueue_pixels
// caught by: enqueue-covers
// says: beyond the picture
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {
        ((size_t)width + GROUP_SIZE - 1) * GROUP_SIZE,
        ((size_t)height + GROUP_SIZE - 1) * GROUP_SIZE,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
