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

// A kernel: its file, the build's options, its name.
typedef struct KernelRow {
    const char *path;
    const char *options;
    const char *name;
} KernelRow;

// Compile n rows that have a path. Returns 0, or -1 after one message. Release with
// programs_free().
int programs_build(const ClSetup *cl, const KernelRow *rows, int n, cl_program *programs);
void programs_free(cl_program *programs, int n);

// Create a kernel of a program. Release it with kernels_free().
cl_kernel kernel_create(cl_program program, const char *name);

// Release those of n kernels that are not NULL.
void kernels_free(cl_kernel *kernels, int n);

// Set n arguments of a kernel that are buffers, from the one with the number `first` on. Returns
// the next number.
cl_uint kernel_set_buffers(cl_kernel kernel, cl_uint first, const cl_mem *buffers, int n);

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
