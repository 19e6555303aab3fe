// mutant: the row pitch counts floats
// task: read_back
// caught by: read_back-picture
// says: pitch|CL_INVALID_VALUE
// looks: unwritten
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, (size_t)width * 4, 0, h_pixels, 0, NULL, NULL));
