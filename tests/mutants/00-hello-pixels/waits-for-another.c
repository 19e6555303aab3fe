// mutant: waits for an event that has come already, and not for the read's
// task: read_back
// caught by: read_back-picture
// says: arrived after
// looks: unwritten
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    cl_event before;
    CL_CHECK(clEnqueueMarkerWithWaitList(queue, 0, NULL, &before));
    CL_CHECK(clWaitForEvents(1, &before));
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_FALSE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
    CL_CHECK(clWaitForEvents(1, &before));
    CL_CHECK(clReleaseEvent(before));
