// mutant: alpha is set to 1
// task: read_back
// caught by: read_back-picture
// says: always 1
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
    for (size_t i = 0; i < region[0] * region[1]; i++) {
        h_pixels[4 * i + 3] = 1.0f;
    }
