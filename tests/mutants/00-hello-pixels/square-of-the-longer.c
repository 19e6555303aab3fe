// mutant: launches a square of the longer side
// task: enqueue_pixels
// caught by: enqueue-covers
// says: longer side
    const int longer = width > height ? width : height;
    const size_t rounded = ((size_t)longer + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
    const size_t global[] = {rounded, rounded}, local[] = {GROUP_SIZE, GROUP_SIZE};
    CL_CHECK(clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global, local, 0, NULL, NULL));
