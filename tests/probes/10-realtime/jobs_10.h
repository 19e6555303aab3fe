// The sections of lab 10's job, and of the answers: as jobs.h has those of the others. For host and
// device.
#ifndef PROBES_JOBS_10_H
#define PROBES_JOBS_10_H

#include "circle_tiles.h"
#include "jobs_07.h"

// Its scenes are those of lab 07, and "scene.K.leaf_spheres", a Sphere for each of the tree's ids.
// Answered by "picture.K", "hits.K" and "work.K": what each pixel's tile cost.

// A tile is what the kernel has where the host says nothing (lanes.h).
enum { TILE_SIDE = 8, TILE_RAYS = TILE_SIDE * TILE_SIDE };

// Section "tile_planes", one call of plane_interval each. Answered by two f32, low and high.
typedef struct TilePlaneJob {
    f32 plane;
    f32 eye;
    f32 low;  // of the directions
    f32 high;
} TilePlaneJob;
LAYOUT_ASSERT(TilePlaneJob, 16);

typedef struct TilePlaneAnswer {
    f32 low;
    f32 high;
} TilePlaneAnswer;
LAYOUT_ASSERT(TilePlaneAnswer, 8);

// Section "tile_children", one call of next_tile_child each. Answered by a NextChildAnswer.
typedef struct TileChildJob {
    KdNode3 node;
    f32 eye;
    f32 split_low;
    f32 split_high;
    TodoEntry at;
    StackState todo;
} TileChildJob;
LAYOUT_ASSERT(TileChildJob, 96);

// Section "tile_waiting", one call of next_tile_waiting each. Answered by a NextWaitingAnswer.
typedef struct TileWaitingJob {
    f32 farthest;
    TodoEntry at;
    StackState todo;
    u32 n_behind;  // so many more wait on top of these: from WAITS_FROM to WAITS_TO
} TileWaitingJob;
LAYOUT_ASSERT(TileWaitingJob, 76);

#define WAITS_NODE (UNTOUCHED - 2)
#define WAITS_FROM 0x1p20f
#define WAITS_TO 0x1p21f

// Section "cones", one call of cone_misses_sphere each. Answered by an i32.
typedef struct ConeJob {
    Vec3 axis;
    f32 cosine;
    f32 sine;
    Vec3 centre;  // seen from the eye
    f32 radius;
} ConeJob;
LAYOUT_ASSERT(ConeJob, 36);

// ---- Part A -------------------------------------------------------------------------------------

// A row of a tile of circles is a vector, where the host says nothing; a tile has as many rows.
enum { ROW_PIXELS = CIRCLE_TILE_SIDE, CIRCLE_TILE_PIXELS = ROW_PIXELS * ROW_PIXELS };

// Section "circle_rows", one call of paint_row each. Answered by a CircleRowAnswer.
typedef struct CircleRowJob {
    f32 dx_squared[ROW_PIXELS];
    f32 dy;
    f32 radius_squared;
    u32 color;
    i32 open[ROW_PIXELS];
    u32 colors[ROW_PIXELS];
} CircleRowJob;
LAYOUT_ASSERT(CircleRowJob, 204);

typedef struct CircleRowAnswer {
    i32 open[ROW_PIXELS];
    u32 colors[ROW_PIXELS];
} CircleRowAnswer;
LAYOUT_ASSERT(CircleRowAnswer, 128);

// Sections "tile_leaves", one call of tile_leaf each, and "circle_tiles", one tile painted each. A
// tile's tree begins at first_node of section "circle_nodes", its lists at first_circle of section
// "leaf_circles". Answered by a TileLeafAnswer and a CircleTileAnswer.
typedef struct CircleTileJob {
    u32 first_node;
    u32 first_circle;
    i32 x;  // the tile's first pixel
    i32 y;
} CircleTileJob;
LAYOUT_ASSERT(CircleTileJob, 16);

typedef struct TileLeafAnswer {
    u32 leaf;
    u32 n_steps;  // as they were counted
} TileLeafAnswer;
LAYOUT_ASSERT(TileLeafAnswer, 8);

typedef struct CircleTileAnswer {
    u32 colors[CIRCLE_TILE_PIXELS];  // row by row
    u32 n_tests;
} CircleTileAnswer;
LAYOUT_ASSERT(CircleTileAnswer, 1028);

#endif
