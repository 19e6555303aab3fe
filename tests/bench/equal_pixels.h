// Are two pictures equal? To the bit in 2D, as generated scenes are exact in float: the tree must
// not change a single pixel. A library that draws circles its own way may differ in a few pixels
// (similar_pixels()); pictures of bytes in a step of rounding.
//
// Used by bench2d.c, pictures3d.c and lit_frames.c before any figure is printed.
#ifndef BENCH_EQUAL_PIXELS_H
#define BENCH_EQUAL_PIXELS_H

#include "image.h"

// Round a picture's colours as a picture of bytes has them.
void round_to_bytes(Image *picture);

// How far two such pictures may be apart in a pixel: rounding may turn the least difference into a
// whole step.
#define BYTE_TOLERANCE (1.5f / 255)

// Compare the first n_rows rows of two pictures of the same size.
//   name   what the message calls the picture
// Returns 0, or -1 after one message on stderr with the first pixel that differs.
int equal_pixels(const Image *picture, const Image *reference, int n_rows, const char *name);

// The share of pixels, or of answers to rays, that may differ in 3D: where a ray grazes a sphere,
// or meets two at one distance, the last place decides what is hit. The naive and the kd-tree
// kernel share every function but the search, and the tiles and Embree compute nearly as they do: a
// pixel in 250 000 was the most that was seen, and of a million rays that begin on a surface none.
#define MAX_AMBIGUOUS_SHARE 1e-4

// How many of the pixels may differ where a library draws circles its own way. Cairo makes them of
// curves with ends at 1/256 of a pixel, and chooses other pixels at a border here and there: one in
// 300 of the lecture's scene.
#define SIMILAR_SHARE 0.01

// The same where only pixels at borders may differ.
int similar_pixels(const Image *picture, const Image *reference, int n_rows, const char *name);

#endif
