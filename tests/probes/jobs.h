// What the grader asks a probe to try: the records of the job file's sections, for host and device.
//
// A probe is given code around a student's code. It runs in the sandbox, tries what the job says
// and writes down what came out; it judges nothing, as whatever runs beside untrusted code may lie.
#ifndef PROBES_JOBS_H
#define PROBES_JOBS_H

#include "circle.h"
#include "kdtree2d.h"
#include "layout.h"

// What an image holds before the student's kernel writes: no scene has this colour.
#define UNWRITTEN (-77.0f)

// The colour of the circle behind the end of circles[], nearest of all and everywhere: no scene has
// it either, and who asks one circle too many paints it.
#define BEYOND_RED 0.140625f
#define BEYOND_GREEN 0.859375f
#define BEYOND_BLUE 0.390625f

// A probe's image is this much larger than the picture on the right and below, and the launch too:
// a work-item without a guard leaves its trace there.
#define PROBE_MARGIN 16

// Section "scene.K"; the circles are in "scene.K.circles", one more than there are, and a tree (lab
// 03) in "scene.K.relations", ".flags", ".boxes" and ".map". The probe answers with "picture.K":
// [image height][image width][4], lab 00 with "readback.K" besides, and lab 03 with "work.K": a
// Work for each pixel, and room behind them.
typedef struct SceneJob {
    i32 n_circles;
    i32 width;  // of the picture; the image has the margin besides
    i32 height;
    i32 maxDepth;  // lab 02 builds a tree with these
    i32 targetElementsPerNode;
} SceneJob;
LAYOUT_ASSERT(SceneJob, 20);

// The image's side for a picture's side: whole work-groups of 16 and the margin.
#define PROBE_IMAGE_SIDE(side) (((side) + 15) / 16 * 16 + PROBE_MARGIN)

// Lab 01: one call of overlaps_N_Nearer. Answered by an i32.
typedef struct OverlapJob {
    Circle circle;
    i32 x;
    i32 y;
    f32 minDepth;
    i32 unused;
} OverlapJob;
LAYOUT_ASSERT(OverlapJob, 48);

// Lab 02: one call of is_leaf. Answered by an i32.
typedef struct LeafJob {
    i32 level;
    u32 n_circles;
    i32 maxDepth;
    i32 targetElementsPerNode;
} LeafJob;
LAYOUT_ASSERT(LeafJob, 16);

// Lab 02: split_box takes a BBox2D and is answered by two, left and right.

// Lab 02: one call of circle_overlaps_box. Answered by an i32.
typedef struct BoxOverlapJob {
    Circle circle;
    BBox2D box;
} BoxOverlapJob;
LAYOUT_ASSERT(BoxOverlapJob, 48);

// Lab 02: distribute is called with ids of scene 0's circles; the answer has DISTRIBUTE_ROOM
// entries: the number returned, then child_ids, UNTOUCHED where nothing was written.
enum { DISTRIBUTE_MAX_IDS = 48, DISTRIBUTE_ROOM = DISTRIBUTE_MAX_IDS + 8, PACK_MAX_IDS = 24 };
#define UNTOUCHED 0xabadcafeu
typedef struct DistributeJob {
    BBox2D child;
    u32 n_ids;
    u32 ids[DISTRIBUTE_MAX_IDS];
} DistributeJob;
LAYOUT_ASSERT(DistributeJob, 212);

// Lab 02: pack_leaf is called on a tree of PACK_NODES nodes whose map already holds n_map entries.
enum { PACK_NODES = 8, PACK_MAP_ROOM = 64 };
typedef struct PackJob {
    u32 id;
    u32 n_map;
    u32 n_ids;
    u32 ids[PACK_MAX_IDS];
} PackJob;
LAYOUT_ASSERT(PackJob, 108);

// What the tree looks like afterwards; nodes start as {id = position, rest 0}, flags as INNER, the
// map as UNTOUCHED.
typedef struct PackAnswer {
    NodeRel relations[PACK_NODES];
    u32 flags[PACK_NODES];
    u32 map[PACK_MAP_ROOM];
    u32 n_map;
} PackAnswer;
LAYOUT_ASSERT(PackAnswer, 420);

// Lab 02 answers scene K with "tree.K" and the four arrays "tree.K.relations", ".flags", ".boxes"
// and ".map"; with "tree.K.refused" where the builder gave up.
typedef struct TreeAnswer {
    u32 n_nodes;
    u32 n_map;
} TreeAnswer;
LAYOUT_ASSERT(TreeAnswer, 8);

// Lab 03: one call of getContainingChild on scene 0's tree. Answered by a u32.
typedef struct ChildJob {
    i32 x;
    i32 y;
    u32 id;
} ChildJob;
LAYOUT_ASSERT(ChildJob, 12);

#endif
