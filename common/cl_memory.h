// Device memory as every lab needs it: the image it draws into, and read-only buffers.
//
// Read next: lab.h.
#ifndef COMMON_CL_MEMORY_H
#define COMMON_CL_MEMORY_H

#include "cl_setup.h"

// Does the device take a picture of this size? Returns 0, or -1 after one message on stderr.
int cl_image_check_size(const ClSetup *cl, int width, int height);

// Make an RGBA float image that kernels write, all black: (0, 0, 0, 0).
//   d_image   out; release with clReleaseMemObject
// Returns 0, or -1 after one message on stderr when the picture is larger than the device takes.
int cl_image_create(const ClSetup *cl, int width, int height, cl_mem *d_image);

// A buffer the kernel only reads, filled from the host; of one unused byte where n_bytes is 0, as
// OpenCL knows no empty buffer. Release with clReleaseMemObject.
cl_mem cl_buffer_create(const ClSetup *cl, const void *h_bytes, size_t n_bytes);

// Release memory objects; NULL among them is fine.
void cl_memory_release(const cl_mem *objects, size_t n_objects);

#endif
