// Following a pixel: its own kernel, run for it alone, writes down what it does (steps/steps.h).
// Needs no window.
//
// Read next: steps/recording.h.
#ifndef FOLLOW_RECORD_H
#define FOLLOW_RECORD_H

#include "steps/steps.h"
#include "world.h"

// Let the kernel draw pixel x, y of the world, and nothing else, and write down its steps.
// Returns 0, or -1 after messages on stderr: the kernel does not build.
int record_pixel(const World *world, const WorldKernel *kernel, int x, int y, Steps *steps);

#endif
