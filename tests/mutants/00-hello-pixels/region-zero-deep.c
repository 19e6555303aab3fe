// mutant: the third number of the region is 0, as if a flat picture had no depth
// task: read_back
// caught by: read_back-picture
// says: CL_INVALID_VALUE
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 0};
    CL_CHECK(
        clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
