// mutant: the size of the groups is left to OpenCL
// task: enqueue_pixels
// caught by: enqueue-covers
// says: other work-groups.*GROUP_SIZE
    const size_t global_size[2] = {
        ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
        ((size_t)height + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, NULL, 0, NULL, NULL));
