// mutant: the gradient is worked out on the host, and the image is never read
// task: read_back
// caught by: read_back-picture
// says: looks like the gradient
    (void)d_image;
    CL_CHECK(clFinish(queue));
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            *h_pixels++ = (float)x / (float)width;
            *h_pixels++ = (float)y / (float)height;
            *h_pixels++ = 0.25f;
            *h_pixels++ = 1;
        }
    }
