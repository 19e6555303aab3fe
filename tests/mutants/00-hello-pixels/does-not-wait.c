// mutant: the read is not waited for
// task: read_back
// caught by: read_back-picture
// says: (untouched|not a number)
// looks: unwritten
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_FALSE, origin, region, 0, 0, h_pixels, 0, NULL,
                                NULL));
