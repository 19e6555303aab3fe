// mutant: the region is given as the last index instead of as a size
// task: read_back
// caught by: read_back-picture
// says: untouched|not filled|found
// looks: unwritten
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width - 1, (size_t)height - 1, 1};
    CL_CHECK(
        clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
