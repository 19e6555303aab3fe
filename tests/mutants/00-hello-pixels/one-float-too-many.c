// mutant: the last pixel is taken to have a fifth float
// task: read_back
// caught by: read_back-picture
// says: behind the end of h_pixels
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(
        clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
    h_pixels[width * height * 4] = 0;
