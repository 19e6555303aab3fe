// mutant: waits for some time, and not for the read
// task: read_back
// caught by: read_back-picture
// says: arrived after
// looks: unwritten
    int usleep(unsigned microseconds);
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_FALSE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
    usleep(300 * 1000);
