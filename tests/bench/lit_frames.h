// What the 3D bench measures of lab 09's picture: whole frames of one scene with shadows and
// mirrors, drawn ray by ray and tile by tile, in two sizes.
//
// The kernels are those of the solutions, each with its own tree. Their pictures are compared
// before any figure is printed.
// Read next: bench.h.
#ifndef BENCH_LIT_FRAMES_H
#define BENCH_LIT_FRAMES_H

#include "bench.h"
#include "case3d.h"

typedef enum LitRenderer {
    LIT_RAYS,   // lab 09's kernel with the tree of lab 06
    LIT_TILES,  // lab 10's with its own
    N_LIT_RENDERERS,
} LitRenderer;

// How often a ray is mirrored at most, 0, 1 or 2 times; and how many kinds of frames there are, of
// each size.
enum { N_MIRROR_NUMBERS = 3, N_LIT_SIDES = 2, N_LIT_FRAMES = N_LIT_SIDES * N_MIRROR_NUMBERS };

typedef struct LitFrame {
    int side;  // of the picture, pixels
    int n_mirrors;
    cl_kernel kernels[N_LIT_RENDERERS];  // with their arguments set
    char name[64];                       // "sphereflake, 1024x1024, 2 mirrors"
} LitFrame;

// Make frames of a case that is prepared ready to be drawn, and run a first work-group of each
// kernel. Returns 0, or -1 after one message. Release with lit_frames_free(), after a failure too.
int lit_frames_prepare(LitFrame frames[N_LIT_FRAMES], const ClSetup *cl, const Case3D *bench_case);
void lit_frames_free(LitFrame frames[N_LIT_FRAMES]);

// A round: draw each several times in both ways, one way after the other. The case's pictures are
// drawn over. Returns 0, or -1 after one message: more pixels differ than rounding explains.
int lit_frames_measure(LitFrame frames[N_LIT_FRAMES], const ClSetup *cl, const Case3D *bench_case,
                       Measurements *measurements);

#endif
