// What lab 10's judge asks of a submission: inputs of its functions, and scenes with their trees.
// Intervals are rolled and judged in judge_10_planes.c, the search's two steps in
// judge_10_children.c and judge_10_waiting.c, cones in judge_10_cones.c (rolled in
// judge_10_cone_inputs.c), scenes in judge_10_scenes.c, the work of tiles in judge_10_work.c, rows
// of circles in judge_10_rows.c, tiles of circles in judge_10_circles.c, and their leaves in
// judge_10_leaves.c.
#ifndef JUDGE_JUDGE_10_H
#define JUDGE_JUDGE_10_H

#include "job_scene3d.h"
#include "jobs_10.h"
#include "judge.h"
#include "work.h"

// ---- Functions --------------------------------------------------------------------------------

// How many inputs of each range are at most what the kernels send for whole pictures
// (judge_10_sent.c): the first ones.
enum { N_SENT_PLANES = 300, N_SENT_CONES = 300, N_SENT_ROWS = 300 };

// How many inputs each range has; a function's ranges follow one another.
enum {
    N_TILE_PLANE_INPUTS = N_SENT_PLANES + 400,  // 3 ranges: see PlaneRange10
    N_TILE_CHILD_INPUTS = 300,  // 2 ranges: where one child is met, and where both are
    N_TILE_WAITING_INPUTS = 400,
    N_CONE_INPUTS = N_SENT_CONES + 400,  // 3 ranges: see ConeRange
    N_TILE_PLANES = 3 * N_TILE_PLANE_INPUTS,
    N_TILE_CHILDREN = 2 * N_TILE_CHILD_INPUTS,
    N_CONES = 3 * N_CONE_INPUTS,
};

// Directions of one sign, of both, and an eye on the plane.
enum PlaneRange10 { TILES_ONE_WAY, TILES_BOTH_WAYS, TILES_ON_PLANE, N_PLANE_RANGES_10 };
// Hit or missed by far, by a hair, and in strange places.
enum ConeRange { CONES_CLEAR, CONES_HAIR, CONES_EDGES };

// Part A: rows that nothing is painted in yet, and rows that are painted in part.
enum RowRange { ROWS_OPEN, ROWS_PAINTED, N_ROW_RANGES };
enum { N_ROW_INPUTS = N_SENT_ROWS + 200, N_ROWS_10 = N_ROW_RANGES * N_ROW_INPUTS };

extern const Function tile_plane_10, tile_child_10, tile_end_10, tile_next_10, cone_10;
extern const Function circle_row_10, tile_leaf_10, leaf_steps_10;
extern const Function circle_pixels_10, circle_work_10;

// ---- Scenes -----------------------------------------------------------------------------------

// In the order of the job.
enum {
    RANDOM = 0,
    N_RANDOM = 8,
    EDGES = RANDOM + N_RANDOM,
    N_EDGES = 9,
    N_SCENES = EDGES + N_EDGES,
};

// Roll the scenes, with their trees and what is expected. Returns 0, or -1 after one message.
int roll_scenes_10(Random *random, JobScene3D scenes[N_SCENES]);

// Write scene K. Returns 0, or -1.
int scene_10_write(const JobScene3D *scene, int k, FILE *file);

// The most that a right search may do for the tile whose first pixel is (x, y).
//   must_ask   out: 1 where a ray certainly hits a sphere, so that one has to be asked
Work tile_10_most(const JobScene3D *scene, int x, int y, int *must_ask);

// ---- Scenes of circles ------------------------------------------------------------------------

enum {
    N_CIRCLE_SCENES = 9,
    MOST_CIRCLES = 120,  // of one scene
    N_CIRCLE_TILES = 1 + 5 * 4 + 5 * 4 + 8 * 8 + 20 * 1 + 5 * 4 + 61 * 1 + 1 * 20 + 5 * 4,
    // Where nodes stand that 16 bits cannot number; of 8 or 16 bits of it nothing is left that is a
    // node of a tree.
    FAR_NODE = 0x10180,
    MOST_CIRCLE_NODES = 2 * N_CIRCLE_TILES + FAR_NODE,
    MOST_LEAF_CIRCLES = N_CIRCLE_TILES * MOST_CIRCLES,
};

// Its tree and lists are in the job's arrays.
typedef struct CircleScene10 {
    Circle circles[MOST_CIRCLES];
    u32 colors[MOST_CIRCLES];
    int n_circles;
} CircleScene10;

// ---- The job ----------------------------------------------------------------------------------

typedef struct Job10 {
    Job job;
    TilePlaneJob planes[N_TILE_PLANES];
    TileChildJob children[N_TILE_CHILDREN];
    TileWaitingJob waiting[N_TILE_WAITING_INPUTS];
    ConeJob cones[N_CONES];
    JobScene3D scenes[N_SCENES];
    CircleRowJob rows[N_ROWS_10];
    CircleScene10 circle_scenes[N_CIRCLE_SCENES];
    TileNode circle_nodes[MOST_CIRCLE_NODES];
    TileCircle leaf_circles[MOST_LEAF_CIRCLES];
    CircleTileJob circle_tiles[N_CIRCLE_TILES];
    int scene_of_tile[N_CIRCLE_TILES];
} Job10;

void roll_planes_10(Random *random, Job10 *job);
void roll_children_10(Random *random, Job10 *job);
void roll_waiting_10(Random *random, Job10 *job);

// What a crash of next_tile_waiting with this TileWaitingJob comes from, or NULL.
const char *suspect_waiting_10(const void *input);
void roll_cones_10(Random *random, Job10 *job);
// How far off rounding may be: of the sphere's distance from the cone's border, and of its size.
double cone_rounding_10(Vec3 centre, double size);
// What takes a number off the grid of 1/16: less than a step of it.
float random_off_grid(Random *random);
void roll_rows_10(Random *random, Job10 *job);
int roll_circles_10(Random *random, Job10 *job);  // 0, or -1 after one message

// Does float decide as double does for each pixel of a row, whichever way it rounds?
int row_10_is_decided(const CircleRowJob *job);

// Put what the kernels send for whole pictures among the inputs.
void add_sent_10(Random *random, Job10 *job);

// The leaf of circle tile i.
u32 leaf_10_of_tile(const Job10 *job, int i);

#endif
