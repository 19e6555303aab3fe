// What the bench of tricks measures: one scene, drawn by a kernel of lab 10 with all its tricks and
// without one at a time.
//
// Used by bench_tricks.c. Read next: trick.h.
#ifndef BENCH_TRICK_CASE_H
#define BENCH_TRICK_CASE_H

#include "image.h"
#include "scene2d.h"
#include "scene3d.h"
#include "tile_buffers.h"
#include "trick.h"

// The picture's side, pixels.
#define TRICK_SIDE 1024

// Scenes of each part.
enum { N_TRICK_SCENES = 3 };

typedef struct TrickCase {
    Part part;
    const char *scene_name;  // as --scene takes it
    Scene2D circles;         // CIRCLES
    cl_mem d_nodes, d_leaf_circles, d_pixels, d_image;
    cl_mem d_hidden_nodes, d_hidden_circles;  // the same tree with hidden circles in its lists
    Scene3D spheres;                          // SPHERES
    TileBuffers tiles, small_leaves;
    cl_kernel kernels[MAX_TRICKS];  // with their arguments set
    TileShape shapes[MAX_TRICKS];
} TrickCase;

// Compile a part's program without one of its tricks.
//   folder   there, in tricks/NAME, the changed texts are kept
// Returns it, or NULL after one message.
cl_program trick_build(const ClSetup *cl, Part part, const Trick *trick, const char *folder);

// Make a zeroed case ready to be drawn: opens the scene, builds the trees, copies all to the device
// and runs each kernel once, so that the driver has finished compiling before anything is timed.
//   scene      the number of the part's scene
//   programs   of the part's tricks
// Returns 0, or -1 after one message. Release with trick_case_free(), after a failure too.
int trick_case_prepare(TrickCase *trick_case, const ClSetup *cl, Part part, int scene,
                       const cl_program *programs);
void trick_case_free(TrickCase *trick_case);

// Make every pixel of a kernel's picture one that no kernel draws.
void trick_case_spoil(const TrickCase *trick_case, const ClSetup *cl, int trick);

// Draw a frame and wait for it. Returns the milliseconds from the launch until the queue is empty.
double trick_case_draw(const TrickCase *trick_case, const ClSetup *cl, int trick);

// The picture that a kernel has drawn, as floats.
void trick_case_read(const TrickCase *trick_case, const ClSetup *cl, int trick, Image *picture);

#endif
