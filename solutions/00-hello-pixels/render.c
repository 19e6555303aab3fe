// Lab 00: from a built kernel to pixels in the host's memory.
//
// Flow: [no scene] -> BUFFERS -> KERNEL -> IMAGE. Called by main.c, which makes the image and the
// kernel; the kernel itself is gradient.cl.
#include "render.h"

void set_arguments(cl_kernel kernel, int width, int height, cl_mem d_image)
{
    // TASK set_arguments: call clSetKernelArg once for each of the three parameters of the kernel.
    //> (void)kernel, (void)width, (void)height, (void)d_image;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof width, &width));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof height, &height));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_image, &d_image));
    // END set_arguments
}

void enqueue_pixels(cl_command_queue queue, cl_kernel kernel, int width, int height)
{
    // TASK enqueue_pixels: OpenCL 1.2 takes whole work-groups only, so round both sizes up to the
    // next multiple of GROUP_SIZE, then clEnqueueNDRangeKernel.
    //> (void)queue, (void)kernel, (void)width, (void)height;
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {
        ((size_t)width + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
        ((size_t)height + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE,
    };
    CL_CHECK(
        clEnqueueNDRangeKernel(queue, kernel, 2, NULL, global_size, local_size, 0, NULL, NULL));
    // END enqueue_pixels
}

void read_back(cl_command_queue queue, cl_mem d_image, int width, int height, float *h_pixels)
{
    // TASK read_back: a blocking clEnqueueReadImage of the whole picture.
    //> (void)queue, (void)d_image, (void)width, (void)height, (void)h_pixels;
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(
        clEnqueueReadImage(queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels, 0, NULL, NULL));
    // END read_back
}
