// mutant: one work-group is launched: the local size is given as the global size too
// task: enqueue_pixels
// caught by: enqueue-covers
// says: nobody wrote
// looks: unwritten
    (void)width, (void)height;
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, local_size, local_size, 0, NULL, NULL));
