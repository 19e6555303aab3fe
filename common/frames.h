// Drawing one frame many times and telling how long it takes.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: stats.h, where the times go.
#ifndef COMMON_FRAMES_H
#define COMMON_FRAMES_H

#include "cl_setup.h"
#include "stats.h"

// Launches a kernel over width x height pixels; need not wait for it.
typedef void EnqueuePixels(cl_command_queue queue, cl_kernel kernel, int width, int height);

// Draw a first frame that is not counted (the driver finishes its compiling there), then n_frames
// more, each waited for, and add frame.min_ms, frame.median_ms and frame.max_ms to the figures.
void frames_draw(const ClSetup *cl, EnqueuePixels *enqueue, cl_kernel kernel, int width, int height,
                 int n_frames, Stats *stats);

#endif
