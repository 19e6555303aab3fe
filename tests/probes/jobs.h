// What the grader asks a probe to try: the records of the job file's sections, for host and device.
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

// Lab 00: a scene is a size, and "scene.K.pattern" the key, a u32, of what is in the image that
// read_back is given (pattern.h). Besides "picture.K" the answers are "arguments.K", an
// ArgumentsAnswer, "items.K", the number of work-items at each place of the image, [image
// height][image width], and N_ITEMS_REST numbers behind them, and "readback.K", [height][width][4]
// and N_READ_BACK_REST floats behind them: READ_BACK_GUARD, which must stay UNWRITTEN, and one that
// is not 0 where more arrived after read_back had returned.
enum { READ_BACK_GUARD = 4, READ_BACK_LATE = READ_BACK_GUARD, N_READ_BACK_REST };
typedef struct ArgumentsAnswer {
    i32 error;       // of launching a kernel with what set_arguments handed over: an OpenCL status
    f32 arrived[4];  // what that kernel wrote: width, height, 0, 1; UNWRITTEN where it did not
} ArgumentsAnswer;
LAYOUT_ASSERT(ArgumentsAnswer, 20);

enum {
    ITEMS_FAR,              // work-items that stand outside of the image
    ITEMS_IN_OTHER_GROUPS,  // those in work-groups that are not 16 x 16
    ITEMS_GROUP_WIDTH,      // the size of one of these
    ITEMS_GROUP_HEIGHT,
    N_ITEMS_REST,
};

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
    i32 n_failed;
} LeafJob;
LAYOUT_ASSERT(LeafJob, 20);

// Lab 02: split_box takes a BBox2D and is answered by two, left and right.

// Lab 02: one call of circle_overlaps_box. Answered by an i32.
typedef struct BoxOverlapJob {
    Circle circle;
    BBox2D box;
} BoxOverlapJob;
LAYOUT_ASSERT(BoxOverlapJob, 48);

// Lab 02: distribute is called with ids of the circles of scene DISTRIBUTE_SCENE; the answer has
// DISTRIBUTE_ROOM entries: the number returned, then child_ids, UNTOUCHED where nothing was
// written.
enum { DISTRIBUTE_SCENE = 6, DISTRIBUTE_MAX_IDS = 600, DISTRIBUTE_ROOM = DISTRIBUTE_MAX_IDS + 8 };
#define UNTOUCHED 0xabadcafeu
typedef struct DistributeJob {
    BBox2D child;
    u32 n_ids;
    u32 ids[DISTRIBUTE_MAX_IDS];
} DistributeJob;
LAYOUT_ASSERT(DistributeJob, 2420);

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

// What the tree looks like afterwards; nodes start as {id = position, rest 0}, flags as INNER,
// cells as PACK_CELL, the map as UNTOUCHED.
typedef struct PackAnswer {
    NodeRel relations[PACK_NODES];
    u32 flags[PACK_NODES];
    BBox2D boxes[PACK_NODES];
    u32 map[PACK_MAP_ROOM];
    u32 n_map;
    u32 n_nodes;
} PackAnswer;
LAYOUT_ASSERT(PackAnswer, 1656);
#define PACK_CELL(id) ((BBox2D){(f32)(id), (f32)(id) + 2, 1, 3})

// Lab 02 answers scene K with "tree.K" and the four arrays "tree.K.relations", ".flags", ".boxes"
// and ".map"; with "tree.K.refused", a u32, where the builder gave up.
typedef enum TreeRefusal {
    TREE_TOO_LARGE,
    TREE_OF_TOO_MANY_IDS,  // a child was given more of them than its parent has
    TREE_OF_LONG_LISTS,    // a leaf took more room than its list needs
    N_TREE_REFUSALS,
} TreeRefusal;

typedef struct TreeAnswer {
    u32 n_nodes;
    u32 n_map;
} TreeAnswer;
LAYOUT_ASSERT(TreeAnswer, 8);

// Lab 03: one call of getContainingChild on the nodes in sections "children.relations" and
// "children.boxes". Answered by a u32.
typedef struct ChildJob {
    i32 x;
    i32 y;
    u32 id;
} ChildJob;
LAYOUT_ASSERT(ChildJob, 12);

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

// ---- Lab 06 -------------------------------------------------------------------------------------

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

// choose_split takes a BBox3D and is answered by a KdSplit of lab 06, which is laid out so.
typedef struct SplitAnswer3D {
    u32 axis;
    f32 pos;
} SplitAnswer3D;
LAYOUT_ASSERT(SplitAnswer3D, 8);

// One call of sphere_overlaps_box. Answered by an i32.
typedef struct SphereBoxJob {
    Sphere sphere;
    BBox3D box;
} SphereBoxJob;
LAYOUT_ASSERT(SphereBoxJob, 40);

// What the tree of a PackJob looks like afterwards; nodes start as PACK_NODE, ids as UNTOUCHED.
#define PACK_SPLIT_POS 3.5f
#define PACK_SPLIT_AXIS 1u
#define PACK_NODE ((KdNode3){PACK_SPLIT_POS, PACK_SPLIT_AXIS, UNTOUCHED, UNTOUCHED})
typedef struct PackAnswer3D {
    KdNode3 nodes[PACK_NODES];
    u32 sphere_ids[PACK_MAP_ROOM];
    u32 n_sphere_ids;
    u32 n_nodes;
} PackAnswer3D;
LAYOUT_ASSERT(PackAnswer3D, 1496);

// Section "todo": a u32, TODO_LEVELS. fits_todo is called with every level from 1 to this. Answered
// by an i32 each.
#define TODO_LEVELS (2 * TODO_SIZE)

// ---- Labs 04, 05 and 07 ------------------------------------------------------------------------

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

// Lab 04: section "views", one call of camera_axes each. Answered by "axes", three Vec3: right, up
// and forward, UNWRITTEN where nothing was written.
typedef struct ViewJob {
    Vec3 from;
    Vec3 at;
    Vec3 up;
} ViewJob;
LAYOUT_ASSERT(ViewJob, 36);

// Lab 04: section "pixels", one call of pixel_on_display and of primary_ray each.
typedef struct PixelJob {
    i32 x;
    i32 y;
    i32 width;
    i32 height;
    Camera camera;
} PixelJob;
LAYOUT_ASSERT(PixelJob, 68);

typedef struct PixelAnswer {
    Vec3 on_display;
    Vec3 origin;  // and the rest of the ray
    Vec3 direction;
    f32 t_min;
    f32 t_max;
} PixelAnswer;
LAYOUT_ASSERT(PixelAnswer, 44);

// Lab 05: section "roots", one call of nearest_root each. Answered by an f32.
typedef struct RootJob {
    f32 b;
    f32 disc;
    f32 radius;
    f32 t_min;
} RootJob;
LAYOUT_ASSERT(RootJob, 16);

// Lab 05: sections "textbook" and "projection", one call of intersect_textbook or intersect_sphere
// each. Answered by an f32.
typedef struct SphereRayJob {
    Sphere sphere;
    Vec3 origin;
    Vec3 direction;
    f32 t_min;
    i32 unused;
} SphereRayJob;
LAYOUT_ASSERT(SphereRayJob, 48);

// Lab 05, alone: in the scenes of nearest_hit the ray of pixel (x, y) goes from (x, y, 0) along z,
// with this t_min. Answered by "hits.K" and "work.K", both width x height.
#define SQUARES_T_MIN 0.25f

// Lab 05: section "normals", one call of surface_normal each. Answered by a Vec3.
typedef struct NormalJob {
    Sphere sphere;
    Vec3 point;
    Vec3 direction;
} NormalJob;
LAYOUT_ASSERT(NormalJob, 40);

// Lab 05: section "shades", one call of shade each, and alone "pixel_shades", those of whole
// pictures. Answered by a Vec3. The lights are n_lights from first_light on in section "lights";
// what follows them must not shine.
typedef struct ShadeJob {
    Vec3 point;
    Vec3 normal;
    Material material;
    i32 first_light;
    i32 n_lights;
} ShadeJob;
LAYOUT_ASSERT(ShadeJob, 64);

// ---- Lab 07 -------------------------------------------------------------------------------------

// Its scenes are those of labs 04 and 05, with a tree.

// Section "clips", one call of clip_to_box each. The ray's own t_min and t_max are the same.
typedef struct ClipJob {
    BBox3D box;
    Vec3 origin;
    Vec3 direction;
    f32 t_min;
    f32 t_max;
} ClipJob;
LAYOUT_ASSERT(ClipJob, 56);

typedef struct ClipAnswer {
    i32 is_met;
    f32 t_min;
    f32 t_max;
} ClipAnswer;
LAYOUT_ASSERT(ClipAnswer, 12);

// Section "sides", one call of near_side each. Answered by a u32.
typedef struct SideJob {
    KdNode3 node;
    f32 origin;
    f32 inverse;  // 1 / direction
} SideJob;
LAYOUT_ASSERT(SideJob, 24);

// Section "planes", one call of children_on_ray each.
typedef struct PlaneJob {
    KdNode3 node;
    f32 origin;
    f32 inverse;
    f32 t_min;
    f32 t_max;
} PlaneJob;
LAYOUT_ASSERT(PlaneJob, 32);

// ONLY_NEAR, ONLY_FAR and BOTH of choose_children.cl, or none of them.
enum { PLANE_ONLY_NEAR, PLANE_ONLY_FAR, PLANE_BOTH, PLANE_UNKNOWN };

typedef struct PlaneAnswer {
    u32 children;
    f32 t_split;
} PlaneAnswer;
LAYOUT_ASSERT(PlaneAnswer, 8);

// Section "leaves", one call of search_leaf each, with the spheres of section "leaf_spheres" and
// the ids of section "leaf_ids".
typedef struct SearchJob {
    KdNode3 node;
    Vec3 origin;
    Vec3 direction;
    f32 t;  // the nearest hit so far
    u32 sphere;
} SearchJob;
LAYOUT_ASSERT(SearchJob, 48);

typedef struct SearchAnswer {
    f32 t;
    u32 sphere;
    u32 n_tests;  // calls of intersect_sphere
} SearchAnswer;
LAYOUT_ASSERT(SearchAnswer, 12);

// A todo stack: its uppermost entries, the last on top, on others that all look like `lowest`. In
// an answer n_lower is how many of these are as they were; entries above the top are UNTOUCHED.
enum { STACK_ENTRIES = 4 };

typedef struct StackState {
    u32 n_lower;
    u32 n;  // entries in all
    TodoEntry upper[STACK_ENTRIES];
} StackState;
LAYOUT_ASSERT(StackState, 56);

// Section "next_child", one call of next_child each.
typedef struct NextChildJob {
    KdNode3 node;
    f32 origin;
    f32 inverse;
    f32 t_min;
    f32 t_max;
    StackState todo;
} NextChildJob;
LAYOUT_ASSERT(NextChildJob, 88);

typedef struct NextChildAnswer {
    TodoEntry next;
    StackState todo;
} NextChildAnswer;
LAYOUT_ASSERT(NextChildAnswer, 68);

// Section "next_waiting", one call of next_waiting each.
typedef struct NextWaitingJob {
    f32 t;  // the nearest hit so far
    u32 sphere;
    TodoEntry at;
    StackState todo;
} NextWaitingJob;
LAYOUT_ASSERT(NextWaitingJob, 76);

typedef struct NextWaitingAnswer {
    i32 goes_on;
    TodoEntry at;
    StackState todo;
} NextWaitingAnswer;
LAYOUT_ASSERT(NextWaitingAnswer, 72);

#endif
