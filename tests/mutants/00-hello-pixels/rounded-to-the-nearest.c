// mutant: rounds to the nearest multiple
// task: enqueue_pixels
// caught by: enqueue-covers
// says: rounded down
// looks: unwritten
    size_t global[2], local[2] = {GROUP_SIZE, GROUP_SIZE};
    global[0] = (size_t)((float)width / GROUP_SIZE + 0.5f) * GROUP_SIZE;
    global[1] = (size_t)((float)height / GROUP_SIZE + 0.5f) * GROUP_SIZE;
    CL_CHECK(clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global, local, 0, NULL, NULL));
