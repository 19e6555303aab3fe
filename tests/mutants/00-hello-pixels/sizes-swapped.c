// mutant: the global size is height, width
// task: enqueue_pixels
// caught by: enqueue-covers
// says: each other
// looks: unwritten
    const size_t local[2] = {GROUP_SIZE, GROUP_SIZE};
    size_t global[2] = {(size_t)height, (size_t)width};
    for (int i = 0; i < 2; i++) {
        global[i] = (global[i] + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
    }
    CL_CHECK(clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global, local, 0, NULL, NULL));
