// right: a read that does not block, and a wait for its event
// task: read_back
    const size_t origin[3] = {0}, region[3] = {(size_t)width, (size_t)height, 1};
    cl_event arrived;
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_FALSE, origin, region, 0, 0, h_pixels, 0, NULL,
                                &arrived));
    CL_CHECK(clWaitForEvents(1, &arrived));
    CL_CHECK(clReleaseEvent(arrived));
