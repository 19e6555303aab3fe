// Lab 00: from a built kernel to pixels in the host's memory.
//
// Flow: [no scene] -> BUFFERS -> KERNEL -> IMAGE. Called by main.c, which makes the image and the
// kernel; the kernel itself is gradient.cl.
#include "render.h"

void set_arguments(cl_kernel kernel, int width, int height, cl_mem d_image)
{
    // TASK set_arguments: call clSetKernelArg once for each of the three parameters of the kernel.
    (void)kernel, (void)width, (void)height, (void)d_image;
    // END set_arguments
}

void enqueue_pixels(cl_command_queue queue, cl_kernel kernel, int width, int height)
{
    // TASK enqueue_pixels: OpenCL 1.2 takes whole work-groups only, so round both sizes up to the
    // next multiple of GROUP_SIZE, then clEnqueueNDRangeKernel.
    (void)queue, (void)kernel, (void)width, (void)height;
    // END enqueue_pixels
}

void read_back(cl_command_queue queue, cl_mem d_image, int width, int height, float *h_pixels)
{
    // TASK read_back: a blocking clEnqueueReadImage of the whole picture.
    (void)queue, (void)d_image, (void)width, (void)height, (void)h_pixels;
    // END read_back
}
