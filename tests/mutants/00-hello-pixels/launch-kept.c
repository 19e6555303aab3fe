// mutant: the first call's global size is kept
// task: enqueue_pixels
// caught by: enqueue-covers
// says: earlier
// looks: unwritten
    static size_t global[2] = {0, 0};
    const size_t local[2] = {GROUP_SIZE, GROUP_SIZE};
    if (global[0] == 0) {
        global[0] = ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
        global[1] = ((size_t)height + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
    }
    CL_CHECK(clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global, local, 0, NULL, NULL));
