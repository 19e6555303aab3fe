// The three host steps around every kernel: arguments, launch, read back. Tasks of lab 00.
#ifndef RENDER_H
#define RENDER_H

#include "cl_check.h"

// The work-group is a square of GROUP_SIZE x GROUP_SIZE work-items: 256, which every GPU takes.
#define GROUP_SIZE 16

// Hand the kernel `gradient` its arguments, in the order of its parameter list in gradient.cl.
void set_arguments(cl_kernel kernel, int width, int height, cl_mem d_image);

// Launch the kernel with one work-item per pixel, in groups of GROUP_SIZE x GROUP_SIZE. Returns as
// soon as the launch is in the queue; the kernel may not have run yet.
void enqueue_pixels(cl_command_queue queue, cl_kernel kernel, int width, int height);

// Wait for the kernel and copy the picture to the host.
//   h_pixels[height][width][4]   out, RGBA float, row 0 first
void read_back(cl_command_queue queue, cl_mem d_image, int width, int height, float *h_pixels);

#endif
