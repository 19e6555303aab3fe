// Timing frames from the host: from the launch until the queue is empty.
#include "frames.h"

#include <stdio.h>
#include <stdlib.h>

void frames_draw(const ClSetup *cl, EnqueuePixels *enqueue, cl_kernel kernel, int width, int height,
                 int n_frames, Stats *stats)
{
    double *milliseconds = calloc((size_t)n_frames, sizeof *milliseconds);
    if (milliseconds == NULL) {
        fprintf(stderr, "frames: no memory for the times of %d frames\n", n_frames);
        exit(EXIT_FAILURE);
    }
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
