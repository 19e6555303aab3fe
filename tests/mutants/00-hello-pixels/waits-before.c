// mutant: waits before the read, and not for it
// task: read_back
// caught by: read_back-picture
// says: arrived after
// looks: unwritten
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clFinish(queue));
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_FALSE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
