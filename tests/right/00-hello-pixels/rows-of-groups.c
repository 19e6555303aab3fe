// right: a launch for each row of groups, each with its offset
// task: enqueue_pixels
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {((size_t)width + GROUP_SIZE - 1) & ~(size_t)(GROUP_SIZE - 1),
                                   GROUP_SIZE};
    for (int y = 0; y < height; y += GROUP_SIZE) {
        const size_t offset[2] = {0, (size_t)y};
        CL_CHECK(clEnqueueNDRangeKernel(queue, kernel, 2, offset, global_size, local_size, 0, NULL,
                                        NULL));
    }
