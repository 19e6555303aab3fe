// Creating a kernel, starting it over a part of the picture and reading it back, and what the bench
// asks of a device.
//
// Used by all that draws with kernels.
#ifndef BENCH_LAUNCH_H
#define BENCH_LAUNCH_H

#include "cl_setup.h"
#include "image.h"

// The work-group of the labs' main.c.
#define GROUP_SIZE 16

// Is the device a CPU? A GPU is fast enough for whole frames, and needs them to be busy.
int device_is_cpu(const ClSetup *cl);

// How many compute units the device has; on a CPU that is threads.
int device_units(const ClSetup *cl);

// Create a kernel of a program. Release it with clReleaseKernel().
cl_kernel kernel_create(cl_program program, const char *name);

// Queue a kernel over the pixels from (x, y) to (x + width - 1, y + height - 1), in work-groups of
// GROUP_SIZE x GROUP_SIZE; width and height are rounded up to whole ones.
void launch(const ClSetup *cl, cl_kernel kernel, int x, int y, int width, int height);

// Make every pixel of an image what no kernel draws, so that one that draws nothing does not show
// the picture of the one before: all channels are NEVER_DRAWN.
#define NEVER_DRAWN (-1.0f)
void spoil_image(const ClSetup *cl, cl_mem d_image, int width, int height);

// Wait for what is queued and copy an image to the host. The picture is of the image's size.
void read_image(const ClSetup *cl, cl_mem d_image, Image *picture);

#endif
