// Are two pictures equal to the bit? No tolerance: generated scenes are exact in float, so the tree
// must not change a single pixel. Used by bench2d.c before any figure is printed.
#ifndef BENCH_EQUAL_PIXELS_H
#define BENCH_EQUAL_PIXELS_H

#include "image.h"

// Round a picture's colours as a picture of bytes has them.
void round_to_bytes(Image *picture);

// Compare the first n_rows rows of two pictures of the same size.
//   name   what the message calls the picture
// Returns 0, or -1 after one message on stderr with the first pixel that differs.
int equal_pixels(const Image *picture, const Image *reference, int n_rows, const char *name);

#endif
