// right: a read that does not block, and asking until it is done
// task: read_back
    const size_t origin[3] = {0}, region[3] = {(size_t)width, (size_t)height, 1};
    cl_event arrived;
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_FALSE, origin, region, 0, 0, h_pixels, 0, NULL,
                                &arrived));
    cl_int status = CL_QUEUED;
    while (status > CL_COMPLETE) {
        CL_CHECK(clGetEventInfo(arrived, CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status, &status,
                                NULL));
    }
    CL_CHECK(clReleaseEvent(arrived));
