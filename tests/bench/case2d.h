// What the bench measures: one kernel over one scene, with its tree if it takes one.
//
// The kernels are those of the solutions, and so is the tree's builder: the bench has no renderer
// of its own.
// Used by bench2d.c.
#ifndef BENCH_CASE2D_H
#define BENCH_CASE2D_H

#include "circle_tree.h"
#include "cl_setup.h"
#include "image.h"
#include "scene2d.h"
#include "tree2d.h"

typedef enum Case2DKind {
    NAIVE,    // lab 01
    KDTREE,   // lab 03 with the tree of lab 02
    TILES,    // lab 10, Part A: tiles of pixels, with a tree of its own
    PAINTER,  // no kernel: see peers2d.h
    CAIRO,    // the same
    N_CASE2D_KINDS,
} Case2DKind;

// "naive", "kd-tree", "tiles", "painter", "cairo": as the CSV file and messages call them.
extern const char *const CASE2D_NAMES[N_CASE2D_KINDS];

enum { MAX_BUFFERS = 5 };

typedef struct Case2D {
    Case2DKind kind;
    const Scene2D *scene;  // kept by the caller
    char scene_name[64];   // "8192 circles, radius 2 to 20"
    int n_rows;  // of the picture that are drawn, from the top; fewer than all where a whole
                 // frame takes too long and every pixel asks all circles, so that rows cost
                 // nearly the same

    cl_kernel kernel;  // with its arguments set
    cl_mem
        buffers[MAX_BUFFERS];  // its first arguments: the circles, the tree; NULL behind the last
    cl_mem d_pixels;           // TILES only

    CircleTree circles;  // these three: PAINTER and CAIRO only; one leaf with all circles
    u32 *h_pixels;       // [height * width]
    int n_threads;       // PAINTER only
} Case2D;

// The programs, compiled. Returns 0, or -1 after one message. Release with programs_free().
int programs2d_build(const ClSetup *cl, cl_program programs[N_CASE2D_KINDS]);

// Make a case ready to be drawn: builds the tree, copies scene and tree to the device, and runs
// one work-group, so that the driver has finished compiling before anything is timed.
// Returns 0, or -1 after one message. Release with case2d_free(), after a failure too.
int case2d_prepare(Case2D *bench_case, const ClSetup *cl, const cl_program *programs,
                   cl_mem d_image);
void case2d_free(Case2D *bench_case);

// Copy the picture of a case that has it as bytes (TILES, PAINTER, CAIRO) into one of its size.
void case2d_read_bytes(const Case2D *bench_case, const ClSetup *cl, Image *picture);

// Draw a frame and wait for it. Returns the milliseconds from the launch until the queue is empty;
// of some rows, scaled to the whole frame.
double case2d_draw(const Case2D *bench_case, const ClSetup *cl);

#endif
