// right: mapped row by row, and copied
// task: read_back
    for (size_t y = 0; y < (size_t)height; y++) {
        const size_t origin[3] = {0, y, 0}, region[3] = {(size_t)width, 1, 1};
        size_t pitch;
        cl_int error;
        const float *row = clEnqueueMapImage(queue, d_image, CL_TRUE, CL_MAP_READ, origin, region,
                                             &pitch, NULL, 0, NULL, NULL, &error);
        CL_CHECK_CREATED(error, clEnqueueMapImage);
        for (size_t i = 0; i < region[0] * 4; i++) {
            h_pixels[y * region[0] * 4 + i] = row[i];
        }
        CL_CHECK(clEnqueueUnmapMemObject(queue, d_image, (void *)row, 0, NULL, NULL));
    }
    CL_CHECK(clFinish(queue));
