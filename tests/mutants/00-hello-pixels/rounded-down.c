// mutant: sizes are rounded down to whole work-groups: the rest on the right and below is not drawn
// task: enqueue_pixels
// caught by: enqueue-covers
// says: nobody wrote
// looks: unwritten
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {
        (size_t)width / GROUP_SIZE * GROUP_SIZE,
        (size_t)height / GROUP_SIZE * GROUP_SIZE,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
