// right: rounded up by the remainder
// task: enqueue_pixels
    size_t global_size[2] = {(size_t)width, (size_t)height};
    size_t local_size[2];
    for (int i = 0; i < 2; i++) {
        const size_t rest = global_size[i] % GROUP_SIZE;
        global_size[i] += rest > 0 ? GROUP_SIZE - rest : 0;
        local_size[i] = GROUP_SIZE;
    }
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
