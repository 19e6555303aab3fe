// What the grader asks a probe to try: the records of the job file's sections, for host and device.
// Here are those of several labs; NN-name/jobs_NN.h has lab NN's own.
//
// A probe is given code around a student's code. It runs in the sandbox, tries what the job says
// and writes down what came out; it judges nothing, as whatever runs beside untrusted code may lie.
#ifndef PROBES_JOBS_H
#define PROBES_JOBS_H

#include "camera.h"
#include "circle.h"
#include "kdtree2d.h"
#include "kdtree3d.h"
#include "layout.h"
#include "shading.h"
#include "sphere.h"
#include "todo.h"

// A section with the id of the task whose answer is tried alone, in a job that asks for no more
// than that needs.
#define PROBE_ALONE "alone"

// What an array holds where nothing was written.
#define UNTOUCHED 0xabadcafeu

// What an image holds before the student's kernel writes: no scene has this colour.
#define UNWRITTEN (-77.0f)

// The colour of the circle behind the end of circles[], nearest of all and everywhere: no scene has
// it either, and a loop that runs one step too far paints it.
#define BEYOND_RED 0.140625f
#define BEYOND_GREEN 0.859375f
#define BEYOND_BLUE 0.390625f

// A probe's image is this much larger than the picture on the right and below, and the launch too:
// a work-item without a guard leaves its trace there.
#define PROBE_MARGIN 16

// Section "scene.K"; the circles are in "scene.K.circles", one more than there are, and a tree (lab
// 03) in "scene.K.relations", ".flags", ".boxes" and ".map", which has one entry more, the id of
// that circle. The probe answers with "picture.K":
// [image height][image width][4], and lab 03 with "work.K" besides: a Work for each pixel, and room
// behind them.
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

// Lab 02: pack_leaf is called on a tree of PACK_NODES nodes whose map already holds n_before
// entries; lab 06: pack_leaf_range, on one that already holds as many ids.
enum { PACK_NODES = 8, PACK_MAX_IDS = 300, PACK_MAP_ROOM = PACK_MAX_IDS + 40 };
typedef struct PackJob {
    u32 id;
    u32 n_before;
    u32 n_ids;
    u32 ids[PACK_MAX_IDS];
} PackJob;
LAYOUT_ASSERT(PackJob, 1212);

// ---- Replays (labs 02 and 06) -------------------------------------------------------------------

// Where one task's answer is tried alone, it is called as the builder would call it on its way to
// the right trees of the job's scenes: with the same inputs, in the same order. The scenes' circles
// or spheres are in "scene.K.circles" or ".spheres", without a section "scene.K".
//     "replay.leaf", "replay.split", "replay.overlap"
//                      as "leaves", "splits" and "overlaps"; so are the answers
//     "replay.todo"    lab 06: levels, an i32 each; answered by an i32 each
//     "replay.lists"   lab 02: a ReplayList for each call of distribute; the children's cells are
//                      in "replay.cells", a BBox2D each. Answered by as many entries for each as
//                      REPLAY_ROOM says: the number returned, then child_ids, UNTOUCHED where
//                      nothing was written.
//     "replay.leaves"  a ReplayList for each call of pack_leaf, scene by scene
//     "replay.trees"   a ReplayTree for each scene
typedef struct ReplayList {
    u32 scene;
    u32 node;      // its id in that scene's tree
    u32 first_id;  // where the node's ids start in section "replay.ids"
    u32 n_ids;
} ReplayList;
LAYOUT_ASSERT(ReplayList, 16);

// How much room the arrays of a scene's tree have.
typedef struct ReplayTree {
    u32 n_nodes;
    u32 n_entries;  // of mapNode2Circles or sphere_ids, without the guard
} ReplayTree;
LAYOUT_ASSERT(ReplayTree, 8);

// How many entries behind an array must stay UNTOUCHED.
enum { REPLAY_GUARD = 6 };
#define REPLAY_ROOM(n_ids) (1 + (size_t)(n_ids) + REPLAY_GUARD)

// The leaves of scene K are packed into one tree, and answered with "packed.K": n_map or
// n_sphere_ids as it is in the end, a u32; with "packed.K.nodes" and, in lab 02, ".flags"; and with
// "packed.K.map", guard included. All start as in section "pack".

// ---- Trees over spheres (labs 06 and 08) --------------------------------------------------------

// Section "scene.K" of lab 06: what a tree is built over. The spheres are in "scene.K.spheres", and
// one more, which must not be asked. Answered by "tree.K", "tree.K.nodes" and "tree.K.ids"; by
// "tree.K" alone where the tree is too large to be written down, and by "tree.K.refused" where the
// builder gave up.
typedef struct TreeJob3D {
    u32 n_spheres;
    i32 maxDepth;
    i32 targetElementsPerNode;
} TreeJob3D;
LAYOUT_ASSERT(TreeJob3D, 12);

typedef struct TreeAnswer3D {
    BBox3D bounds;
    u32 n_nodes;
    u32 n_sphere_ids;
} TreeAnswer3D;
LAYOUT_ASSERT(TreeAnswer3D, 32);

// No right tree of the job has more: answers shall stay a few megabytes.
enum { TREE3D_ANSWER_NODES = 1 << 14, TREE3D_ANSWER_IDS = 1 << 16 };

// The sphere behind the end of an array: a loop that runs too far gets a box or a leaf like no
// other.
#define BEYOND_RADIUS 1e6f

// ---- Pictures of spheres (labs 04, 05, 07, 09 and 10) -------------------------------------------

// Section "scene.K" of a 3D job; its arrays are in "scene.K.spheres", ".material_ids", ".materials"
// and ".lights", each with one entry more than there are, and a tree (lab 07) in ".nodes" and
// ".sphere_ids". Labs 04, 05 and 07 answer with "picture.K", 05 and 07 with "hits.K", a HitAnswer
// for each pixel, and "work.K" besides: a Work for each pixel, and room behind them.
typedef struct SceneJob3D {
    i32 n_spheres;
    i32 n_lights;
    i32 width;  // of the picture; the image has the margin besides
    i32 height;
    Vec3 background;
    Camera camera;  // for this size
    BBox3D bounds;  // of the tree
} SceneJob3D;
LAYOUT_ASSERT(SceneJob3D, 104);

// What a ray hits.
typedef struct HitAnswer {
    f32 t;
    u32 sphere;
} HitAnswer;
LAYOUT_ASSERT(HitAnswer, 8);

// A todo stack: its uppermost entries, the last on top, on others that all look like `lowest`. In
// an answer n_lower is how many of these are as they were; entries above the top are UNTOUCHED.
enum { STACK_ENTRIES = 4 };

typedef struct StackState {
    u32 n_lower;
    u32 n;  // entries in all
    TodoEntry upper[STACK_ENTRIES];
} StackState;
LAYOUT_ASSERT(StackState, 56);

#endif
