// mutant: the global size counts work-groups, as in CUDA, instead of work-items
// task: enqueue_pixels
// caught by: enqueue-covers
// says: nobody wrote
// looks: unwritten
    const size_t n_groups[2] = {
        ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE,
        ((size_t)height + GROUP_SIZE - 1) / GROUP_SIZE,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, n_groups, NULL, 0, NULL, NULL));
