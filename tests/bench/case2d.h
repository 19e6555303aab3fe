// What the bench measures: one kernel over one scene, with a tree of certain limits where it takes
// one.
//
// The kernels are those of the solutions, and so is the tree's builder: the bench has no renderer
// of its own but the fill.
// Used by bench2d.c.
#ifndef BENCH_CASE2D_H
#define BENCH_CASE2D_H

#include "circle_tree.h"
#include "cl_setup.h"
#include "image.h"
#include "scene2d.h"
#include "series.h"
#include "tree2d.h"

typedef enum Case2DKind {
    FILL,     // fill.cl: the floor
    NAIVE,    // lab 01
    KDTREE,   // lab 03 with the tree of lab 02
    TILES,    // lab 10, Part A: tiles of pixels, with a tree of its own
    PAINTER,  // no kernel: see peers2d.h
    CAIRO,    // the same
    N_CASE2D_KINDS,
} Case2DKind;

// "fill", "naive", "kdtree", "tiles", "painter", "cairo": the first column of the CSV file.
extern const char *const CASE2D_NAMES[N_CASE2D_KINDS];

typedef struct Case2D {
    Case2DKind kind;
    const Scene2D *scene;  // kept by the caller
    const char *radii;     // of the scene, "2 to 20", where it is one of the lecture's 8192 circles
    KdTreeLimits limits;   // KDTREE only
    int n_frames;          // frames a round
    int n_rows;  // of the picture that are drawn, from the top; fewer than all where a whole
                 // frame takes too long and every pixel asks all circles, so that rows cost
                 // nearly the same

    cl_kernel kernel;  // with its arguments set
    cl_mem d_circles;
    cl_mem d_nodes_Relations;  // these four: KDTREE only
    cl_mem d_nodes_flag;
    cl_mem d_nodes_BBox;
    cl_mem d_mapNode2Circles;
    cl_mem d_tile_nodes;  // these three: TILES only
    cl_mem d_leaf_circles;
    cl_mem d_pixels;
    u32 n_nodes;
    u32 n_references;  // circle ids in all lists together
    int depth;         // levels there are

    CircleTree circles;  // these three: PAINTER and CAIRO only; one leaf with all circles
    u32 *h_pixels;       // [height * width]
    int n_threads;       // PAINTER only

    Series frames;
    Series mapped;  // TILES only: frames until the host can read the picture
    Series builds;  // KDTREE only: of the tree
} Case2D;

// The programs, compiled. Returns 0, or -1 after one message. Release with programs_free().
int programs_build(const ClSetup *cl, cl_program programs[N_CASE2D_KINDS]);
void programs_free(cl_program programs[N_CASE2D_KINDS]);

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

// Draw a frame of a TILES case and map its picture on the host. Returns the milliseconds until it
// is there.
double case2d_draw_mapped(const Case2D *bench_case, const ClSetup *cl);

// Build the tree and throw it away. Returns the milliseconds, or -1 after one message.
double case2d_time_build(const Case2D *bench_case);

#endif
