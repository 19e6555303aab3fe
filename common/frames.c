// Timing frames from the host: from the launch until the queue is empty (see frames.h).
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: work_stats.c, which counts
// what a frame takes instead of timing it.
#include "frames.h"

#include <stdlib.h>

void frames_draw(const ClSetup *cl, EnqueuePixels *enqueue, cl_kernel kernel, int width, int height,
                 int n_frames, Stats *stats)
{
    double *milliseconds = stats_times_create(n_frames);
    enqueue(cl->queue, kernel, width, height);
    CL_CHECK(clFinish(cl->queue));
    for (int frame = 0; frame < n_frames; frame++) {
        const double start = stats_clock_ms();
        enqueue(cl->queue, kernel, width, height);
        CL_CHECK(clFinish(cl->queue));
        milliseconds[frame] = stats_clock_ms() - start;
    }
    stats_milliseconds(stats, "frame", milliseconds, n_frames);
    free(milliseconds);
}
