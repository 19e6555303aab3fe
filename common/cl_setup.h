// The OpenCL ground that every lab stands on: a device, its context, one in-order queue, and
// programs built from .cl files with errors at the student's own file and line.
//
// Hidden here because it is not the lesson; clCreateImage (lab 00), clCreateBuffer (lab 01),
// clSetKernelArg and clEnqueue... stay in the labs.
// Read next: a lab's main.c.
#ifndef COMMON_CL_SETUP_H
#define COMMON_CL_SETUP_H

#include "cl_check.h"

#include <stdio.h>

// The environment variable that names a device where --device is not given.
#define CL_DEVICE_VARIABLE "COURSE_DEVICE"

typedef struct ClSetup {
    cl_device_id device;
    cl_context context;
    cl_command_queue queue;  // in order, profiling off
    char device_name[256];   // "cpu-haswell-..." as the driver gives it; a longer one is cut off
} ClSetup;

// Open a device.
//   device_choice  a number as cl_setup_list() prints it, or a part of "platform: device" in any
//                  case; NULL takes $COURSE_DEVICE, and the first device found where that is
//                  unset
// Returns 0, or -1 after one message on stderr: no platform, no such device (the message lists what
// there is), a device without images.
int cl_setup_open(const char *device_choice, ClSetup *setup);

// Release what cl_setup_open() made; a zeroed ClSetup is fine.
void cl_setup_close(ClSetup *setup);

// Print every device, one "number  platform: device" a line. Returns 0, or -1 after one message
// when there is no platform, or no device on any.
int cl_setup_list(FILE *out);

// The largest image the device takes, in pixels.
void cl_setup_image_limit(const ClSetup *setup, size_t *max_width, size_t *max_height);

// Build a program from one .cl file.
//   path      the file; it is handed to the compiler with a #line of its own, so that the build log
//             names it; its own folder is searched for #include "..." first
//   options   further build options ("-DCOUNT_WORK -I kernels"), or NULL
// The option -cl-std=CL1.2 is always given.
// Returns the program, or NULL after one message on stderr: the file cannot be read, or the build
// log, "path:line:column: error: ..." each with the source line and a caret under the column.
cl_program cl_setup_build(const ClSetup *setup, const char *path, const char *options);

#endif
