// Do the naive kernel, the kd-tree kernel with either tree, the tiles and each of Embree's calls
// draw the same picture? Asked before any figure is printed.
//
// Read next: bench.h.
#ifndef BENCH_PICTURES3D_H
#define BENCH_PICTURES3D_H

#include "bench.h"
#include "case3d.h"

// A picture of each renderer, and whether there are Embree's.
typedef struct Pictures3D {
    Image images[N_RENDERERS];
    int has_embree;
} Pictures3D;

// Returns 0, or -1 after one message. Release with pictures3d_free().
int pictures3d_create(Pictures3D *pictures);
void pictures3d_free(Pictures3D *pictures);

// Compare the pictures of a case and add how many pixels differ. Where the naive kernel drew only
// its share, only that counts. The tiles' picture has bytes, and the kd-tree's is rounded to bytes
// for it. Returns 0, or -1 after one message: pixels that should be drawn are
// not, or more differ than rounding explains.
int pictures3d_check(Pictures3D *pictures, const Case3D *bench_case, Measurements *measurements);

#endif
