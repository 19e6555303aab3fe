// Are two pictures the same? Asked before a time of their renderers is written. In 2D to the bit,
// as generated scenes are exact in float: the tree must not change a single pixel. Elsewhere a few
// pixels may differ, for the reasons below.
//
// Used by bench2d.c, bench_tricks.c, pictures3d.c and lit_frames.c.
#ifndef BENCH_SAME_PICTURES_H
#define BENCH_SAME_PICTURES_H

#include "image.h"

// Round a picture's colours as a picture of bytes has them.
void round_to_bytes(Image *picture);

// How far two such pictures may be apart in a pixel: rounding may turn the least difference into a
// whole step.
#define BYTE_TOLERANCE (1.5f / 255)

// The share of pixels, or of answers to rays, that may differ in 3D: where a ray grazes a sphere,
// or meets two at one distance, the last place decides what is hit. The naive and the kd-tree
// kernel share every function but the search, and the tiles and Embree compute nearly as they do: a
// pixel in 250 000 was the most that was seen, and of a million rays that begin on a surface none.
#define MAX_AMBIGUOUS_SHARE 1e-4

// How many of the pixels may differ where a library draws circles its own way. Cairo makes them of
// curves with ends at 1/256 of a pixel, and chooses other pixels at a border here and there: one in
// 300 of the lecture's scene.
#define SIMILAR_SHARE 0.01

// Compare two pictures of the same size.
//   tolerance   how far the colours of equal pixels may be apart
//   most        how many pixels may differ
//   names       what the message calls them: "bench3d: sphereflake, tiles beside kd-tree"
// Returns how many pixels differ, or -1 after one message with the first of them: more than `most`.
int pictures_compare(const Image *picture, const Image *reference, float tolerance, int most,
                     const char *names);

#endif
