// mutant: the last row is not read
// task: read_back
// caught by: read_back-picture
// says: last row
// looks: unwritten
    const size_t region[3] = {(size_t)width, 1, 1};
    for (size_t y = 0; y + 1 < (size_t)height; y++) {
        const size_t origin[3] = {0, y, 0};
        CL_CHECK(clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels + y * 4 * region[0], 0, NULL, NULL));
    }
