// right: strips of rows, read by a helper that is called like a function of the probe
// task: read_back
    extern size_t sections_read(cl_command_queue queue, cl_mem d_image, size_t y,
                                const size_t size[2], float *h_pixels);
    const size_t size[2] = {(size_t)width, (size_t)height};
    for (size_t y = 0; y < size[1];) {
        y = sections_read(queue, d_image, y, size, h_pixels);
    }
}

size_t sections_read(cl_command_queue queue, cl_mem d_image, size_t y, const size_t size[2],
                     float *h_pixels)
{
    const size_t n_rows = size[1] - y < 8 ? size[1] - y : 8;
    const size_t origin[3] = {0, y, 0}, region[3] = {size[0], n_rows, 1};
    CL_CHECK(clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0,
                                h_pixels + 4 * y * size[0], 0, NULL, NULL));
    return y + n_rows;
