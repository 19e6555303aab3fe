// What every lab's program does besides its lesson: the command line, the figures of the run, its
// kernels, the time of a frame, the work of each pixel, the end.
//
// A lab's program has one way to fail: one message on stderr, then the end with EXIT_FAILURE.
// Libraries print the message and return an error; a program passes what they return to require().
// The functions declared here end the program themselves. Nothing half-written stays behind: a
// library that fails removes its unfinished file before it returns (output_file.h).
// LAB_NAME, LAB_FOLDER and KERNEL_OPTIONS, which each main.c uses, come from the Makefile.
// Read next: a lab's main.c.
#ifndef COMMON_LAB_H
#define COMMON_LAB_H

#include "cl_setup.h"
#include "options.h"
#include "stats.h"
#include "work_stats.h"

#include <stdlib.h>

// A lab's kernel is built to draw; where work is to be counted, it is built again to count.
enum { LAB_DRAWS, LAB_COUNTS, LAB_MAX_KERNELS };

typedef struct Lab {
    const char *name;  // "01-naive-2d"
    int set;           // the OPTIONS_... that it uses
    Options options;
    ClSetup cl;  // zeroed where no device is opened
    Stats stats;
    int n_kernels;                       // 0, 1, or 2 where the work is counted
    cl_kernel kernels[LAB_MAX_KERNELS];  // [n_kernels]: LAB_DRAWS, LAB_COUNTS
    cl_mem d_work[LAB_MAX_KERNELS];      // where each of them counts; NULL: it does not
} Lab;

// Launches a kernel over width x height pixels; need not wait for it.
typedef void EnqueuePixels(cl_command_queue queue, cl_kernel kernel, int width, int height);

// End the program with EXIT_FAILURE unless the result is 0: whoever returned it printed why.
void require(int result);

// Begin with the command line (options_parse()). Ends the program where the command line is wrong,
// and with EXIT_SUCCESS where it only asks for --help or --list-devices. Finish with lab_end().
Lab lab_begin(int argc, char **argv, const char *name, const char *what, int set);

// The first figures: the lab, the device where one is open, the scene where the lab has one, how
// many elements it has, and the picture's size.
//   count_name, count   "n_circles" and their number; NULL and 0 leave that figure out
void lab_describe(Lab *lab, const char *count_name, int count, int width, int height);

// Build a program from a .cl file: cl_setup_build(), required. Release with clReleaseProgram.
cl_program lab_build_program(const Lab *lab, const char *path, const char *options);

// Build the kernel that draws; and, where --stats or --heat-map was given in a lab with
// OPTIONS_WORK, the same with -DCOUNT_WORK, which counts, with a buffer for its counters.
//   path, options   as cl_setup_build() takes them
//   width, height   the picture, pixels
// Their arguments are still to be set. lab_end() releases them.
void lab_build_kernels(Lab *lab, const char *path, const char *name, const char *options, int width,
                       int height);

// Draw a first frame that is not timed (the driver finishes its compiling there), then as many as
// --frames says, each waited for; frame.min_ms, frame.median_ms and frame.max_ms become figures.
void lab_draw(Lab *lab, EnqueuePixels *enqueue, cl_kernel kernel, int width, int height);

// Where the work is counted, draw one more frame with the kernel that does, and report its counters
// (work_report()). Counting slows a kernel down, so it has a frame of its own, after the picture is
// saved; what that frame draws is not looked at.
void lab_count_work(Lab *lab, EnqueuePixels *enqueue, int width, int height, WorkKind kind);

// Print the figures, write them where --stats says, and release what the Lab holds.
void lab_end(Lab *lab);

#endif
