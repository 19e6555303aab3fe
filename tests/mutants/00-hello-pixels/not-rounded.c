// mutant: the sizes are not rounded up: OpenCL refuses the launch
// task: enqueue_pixels
// caught by: enqueue-covers
// says: CL_INVALID_WORK_GROUP_SIZE
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {
        (size_t)width,
        (size_t)height,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
