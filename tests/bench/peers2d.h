// The peers of the 2D bench: programs that draw the same circles without OpenCL, from the farthest
// to the nearest. A scanline painter in C, with as many threads as a CPU device has compute units
// and with one beside a GPU, and cairo, a well-known 2D library, where its package is installed
// (libcairo2-dev).
//
// Used by case2d.c.
#ifndef BENCH_PEERS2D_H
#define BENCH_PEERS2D_H

#include "circle_tiles.h"

// What is drawn.
typedef struct Circles {
    const TileCircle *circles;  // [n_circles], nearest first
    u32 n_circles;
} Circles;

// Paint the circles, row by row of each, with n_threads threads, into pixels[height * width]: RGBA,
// a byte each, red lowest; 0 where no circle is. The same pixels as the kernels', to the bit.
void painter_draw(Circles circles, int width, int height, int n_threads, u32 *pixels);

// The version of cairo this was built with, "1.16.0"; or NULL when it was built without.
const char *cairo_peer_version(void);

// Fill the circles with cairo, on one thread, without smooth borders. Pixels as above, but for some
// at borders (SIMILAR_SHARE). Returns 0, or -1 after one message.
int cairo_peer_draw(Circles circles, int width, int height, u32 *pixels);

#endif
