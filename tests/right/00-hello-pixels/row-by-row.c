// right: row by row from the bottom, the pitch written out
// task: read_back
    const size_t row_floats = 4 * (size_t)width;
    const size_t region[3] = {(size_t)width, 1, 1};
    for (int y = height - 1; y >= 0; y--) {
        const size_t origin[3] = {0, (size_t)y, 0};
        CL_CHECK(clEnqueueReadImage(queue, d_image, y > 0 ? CL_FALSE : CL_TRUE, origin, region,
                                    row_floats * sizeof *h_pixels, 0,
                                    h_pixels + (size_t)y * row_floats, 0, NULL, NULL));
    }
    CL_CHECK(clFinish(queue));
