// Following a pixel: its own kernel, run for it alone, writes down what it does (steps/steps.h).
// Needs no window.
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: steps/recording.h.
#ifndef VIEW_RECORD_H
#define VIEW_RECORD_H

#include "steps/steps.h"
#include "world.h"

// Let the kernel draw pixel x, y of the world, and nothing else, and write down its steps.
// Returns 0, or -1 after messages on stderr: the kernel does not build.
int record_pixel(const World *world, const WorldKernel *kernel, int x, int y, Steps *steps);

// The steps in words: "leaf 213: t 2.10 to 2.35, 2 wait". The last line says how the pixel ended.
//   lines[RECORD_MAX_LINES]   out
// Returns how many there are.
enum { RECORD_LINE_LENGTH = 40, RECORD_MAX_LINES = MAX_STEPS + 1 };
typedef struct RecordLine {
    char text[96];
} RecordLine;
int record_words(const World *world, const Steps *steps, RecordLine *lines);

#endif
