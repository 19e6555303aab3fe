// What the 3D bench measures: one scene, drawn by the naive kernel of lab 05, by the kd-tree kernel
// of lab 07 with either tree, by the tiles of lab 10 and by Embree; and what a
// ray costs in lab 06's tree.
//
// The kernels, the trees' builders and the camera are those of the solutions: the bench has no
// renderer of its own.
// Read next: pictures3d.h.
#ifndef BENCH_CASE3D_H
#define BENCH_CASE3D_H

#include "cl_setup.h"
#include "embree_peer.h"
#include "image.h"
#include "scene3d.h"
#include "scene_buffers.h"
#include "tile_buffers.h"
#include "tree_buffers.h"

// The picture's side, pixels.
#define CASE3D_SIDE 1024

typedef enum Renderer {
    NAIVE,    // lab 05
    KDTREE,   // lab 07 with the tree of lab 06
    BY_COST,  // lab 07 with the tree of lab 08
    TILES,    // lab 10 with the tree of lab 08, in larger leaves
    EMBREE,   // with its first call; those of its other calls follow
    N_RENDERERS = EMBREE + N_EMBREE_CALLS,
} Renderer;

// As the CSV file and messages call them: "kd-tree", "rtcIntersect8".
extern const char *const RENDERER_NAMES[N_RENDERERS];

// The renderers that are OpenCL kernels; of as many programs, and of one more: lab 07's built with
// -DCOUNT_WORK.
enum { N_KERNELS = EMBREE, COUNTING = N_KERNELS, N_PROGRAMS };

// The part of the picture that the naive kernel draws where the whole takes too long: every ray
// asks every sphere, so that rays cost nearly the same and a part stands for the whole.
typedef struct Share {
    int n_stripes;  // of GROUP_SIZE rows each, spread evenly from top to bottom
    int width;      // of a stripe, pixels, in the middle; CASE3D_SIDE but where one stripe is too
                    // much already
} Share;

// The pixels whose rays a GPU walks through the tree side by side, as many as run in step there.
enum { WORK_GROUP_WIDTH = 8, WORK_GROUP_HEIGHT = 4 };

// What a ray costs in the tree, on average over the picture.
typedef struct WorkOfRay {
    double n_nodes;          // inner nodes
    double n_leaves;         // leaves
    double n_tests;          // spheres asked
    double n_slowest_steps;  // all three together of the ray that has most of WORK_GROUP_WIDTH x
                             // WORK_GROUP_HEIGHT pixels
} WorkOfRay;

typedef struct Case3D {
    const char *scene_name;  // as --scene takes it
    Scene3D scene;
    SceneBuffers buffers;
    TreeBuffers trees[TILES];      // what KDTREE and BY_COST take
    TileBuffers tiles;             // what TILES takes
    cl_kernel kernels[N_KERNELS];  // with their arguments set
    Share share;
    WorkOfRay work;  // in lab 06's tree
} Case3D;

// Compile the programs. Returns 0, or -1 after one message. Release with programs_free().
int programs3d_build(const ClSetup *cl, cl_program programs[N_PROGRAMS]);

// Make a zeroed case with a scene_name ready to be drawn: opens the scene, builds the trees, copies
// all to the device, counts the work of the rays, and runs a first work-group of each kernel, so
// that the driver has finished compiling before anything is timed. Returns 0, or -1 after one
// message. Release with case3d_free(), after a failure too.
int case3d_prepare(Case3D *bench_case, const ClSetup *cl, const cl_program *programs);
void case3d_free(Case3D *bench_case);

// Draw a frame with one of the kernels and wait for it. Returns the milliseconds from the launch
// until the queue is empty; of a share, scaled to the whole frame.
double case3d_draw(const Case3D *bench_case, const ClSetup *cl, Renderer renderer);

// How many pixels NAIVE draws.
int case3d_share_pixels(const Case3D *bench_case);

// What a tree takes until a kernel can search it, milliseconds.
typedef struct TreeTimes {
    double build;
    double copy;  // of its nodes and ids to the device; TILES takes the spheres in the leaves'
                  // order besides, which are not in it
} TreeTimes;

// Build the tree of KDTREE, BY_COST or TILES, copy it to the device and throw both away. Returns 0,
// or -1 after one message.
int case3d_time_tree(const Case3D *bench_case, const ClSetup *cl, Renderer renderer,
                     TreeTimes *times);

#endif
