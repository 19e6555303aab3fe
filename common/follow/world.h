// A scene on the device, the place it is seen from, its tree, and the kernels that can draw it. 2D
// (circles.c) and 3D (rays.c, spheres.c) differ behind this one face.
//
// Read next: record.h, and frame.h of common/view.
#ifndef FOLLOW_WORLD_H
#define FOLLOW_WORLD_H

#include "camera.h"
#include "circle.h"
#include "image.h"
#include "lab.h"
#include "scene3d.h"
#include "sphere.h"
#include "tree2d.h"
#include "tree3d.h"

// From where a world is seen, as numbers. 3D: from, at and up of the view, x, y, z each. 2D: the
// scene's x and y in the top left corner of the picture, and the zoom as a power of two: at 0 a
// pixel of the scene is one of the picture, at 1 two by two.
enum { POSE_MAX_NUMBERS = 9 };
typedef struct Pose {
    f32 numbers[POSE_MAX_NUMBERS];
} Pose;

// What keys and the mouse ask for in one frame.
typedef struct Motion {
    f32 right, up, forward;     // how long to fly each way, seconds
    f32 turn_right, turn_up;    // look round, radians
    f32 orbit_right, orbit_up;  // go round the scene's middle, radians
    f32 drag_right, drag_down;  // pull the scene along, pixels
    int notches;                // of the wheel, or steps of the zoom; inwards is positive
} Motion;

typedef struct World World;

// How a tree is built: by the builder of a lab.
typedef union WorldBuilder {
    int (*circles)(const Circle *h_circles, u32 n_circles, KdTreeLimits limits, KdTree2D *tree);
    int (*spheres)(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits, KdTree3D *tree);
} WorldBuilder;

// A tree that kernels go through.
typedef struct WorldTree {
    WorldBuilder build;
    // Its limits where the user wants these; 0: the user does not say. NULL: what the user wants,
    // as in 2D, where it is always said.
    KdTreeLimits (*limits)(int max_depth, int leaf_size, u32 n_elements);
    // Copy to the device what the kernel needs besides; or NULL. Called after each building.
    void (*complete)(World *world);
} WorldTree;

// A kernel that can draw the world.
typedef struct WorldKernel {
    const char *label;      // what the window calls it: "kd-tree"
    const char *path;       // its .cl file
    const char *function;   // its name there
    const WorldTree *tree;  // NULL: it needs none, and leaves the one that is there
    const char *options;    // as cl_setup_build() takes them
    // The same where they depend on the world, in the place of `options`; or NULL.
    const char *(*options_of)(const World *world);
    // A .cl file around it that writes down the steps of a pixel (steps.h); or NULL, and in one
    // line why none can be followed.
    const char *steps_path, *not_followed;
    // Set its arguments. d_work is its last one: NULL where nothing is counted.
    void (*set_arguments)(const World *world, cl_kernel kernel, cl_mem d_work);
    EnqueuePixels *enqueue;                            // NULL: one work-item a pixel,
    void (*read)(const World *world, Image *picture);  // which is then in world->d_image
    const char *unit;  // what the work is counted for: "tile"; NULL: a pixel
    int has_bounces;   // rays go on from what they hit: it heeds has_shadows and n_bounces
} WorldKernel;

// What the device holds, on the host. Of circles or of spheres, the other ones are NULL; `tree2d`
// or `tree3d` is NULL where there is no tree.
typedef struct WorldData {
    const Circle *circles;  // [n_elements], as the pose shows them
    const KdTree2D *tree2d;
    const Sphere *spheres;  // [n_elements]
    const KdTree3D *tree3d;
    BBox3D bounds;  // of the tree, as the kernel has it: a little wider
    Camera camera;
} WorldData;

// Where 2D and 3D differ. Functions that return an int return 0, or -1 after one message on stderr.
typedef struct WorldKind {
    int set;                // the OPTIONS_... of its scenes
    int n_numbers;          // of a pose
    const char *pose_line;  // what they are, for the first line of a path's file
    const char *elements;   // "spheres"; NULL: none, and no work that is counted
    const char *askers;     // "rays"
    // Open the scene that world->lab->options names, and copy it to the device. Sets width to
    // home, and `own`; there is no tree yet.
    int (*open)(World *world);
    // Release what open() made; a world that is zero from width on is fine.
    void (*close)(World *world);
    // Look from world->pose: bring what the kernels are given up to date.
    int (*place)(World *world);
    // Build world->tree anew within world->limits. Where that fails, the one before stays. NULL: no
    // kernel has a tree.
    int (*grow)(World *world);
    // Change world->pose.
    void (*move)(World *world, Motion motion);
    // The pose of frame `frame` of n_frames on the way of a film, where the user has given none.
    Pose (*film_pose)(const World *world, int frame, int n_frames);
    // The number of the element with these four numbers (x, y, radius, depth or x, y, z, radius):
    // the first one from `start` on, or, where there is none, from 0 on; -1: none.
    int (*find)(const World *world, const f32 *element, int start);
    WorldData (*data)(const World *world);
} WorldKind;

// What a lab has to show. Each lab's own file, NN-name.c, holds one, WORLD_LAB.
typedef struct WorldLab {
    const char *name;       // LAB_NAME
    const char *what;       // one sentence for --help
    const WorldKind *kind;  // CIRCLES, RAYS or SPHERES
    int set;                // OPTIONS_... that it has besides those of all labs of its kind
    // [n_kernels], the lab's own first; where there are others, the last one asks every element.
    const WorldKernel *kernels;
    int n_kernels;
} WorldLab;
extern const WorldLab WORLD_LAB;

// The tree in figures.
typedef struct TreeFigures {
    u32 n_nodes;
    u32 n_listed;  // elements in its leaves, each as often as it is listed
    int depth;     // levels, the root's included
    double build_ms;
} TreeFigures;

struct World {
    Lab *lab;
    const WorldKind *kind;
    int has_shadows;  // of kernels with bounces: do they ask whether light arrives?
    int n_bounces;    // and how many mirrors does a ray meet at most?
    // From here on set by open().
    int width, height;  // the picture, pixels
    int n_elements;
    cl_mem d_image;
    Pose pose, home;   // home: where the scene itself wants to be seen from
    void *own;         // what the kind keeps
    Scene3D *scene3d;  // in 3D: the scene, whose view is that of the pose
    // The tree that is there; NULL: none. From here on set by world_grow().
    const WorldTree *tree;
    int max_depth;  // as the user wants it, or 0
    KdTreeLimits limits;
    TreeFigures figures;
};

// Open the device that lab->options names, and on it the scene. Returns 0, or -1 after one message
// on stderr; close with world->kind->close() either way.
int world_open(World *world, Lab *lab, const WorldLab *world_lab);

// Build a tree in the place of the one that is there.
//   max_depth   levels; 0: what is best
// Returns 0, or -1 after one message on stderr, and the one before stays.
int world_grow(World *world, const WorldTree *tree, int max_depth);

// Which options a lab's program of this folder or of common/view takes, but for its own.
int world_options(const WorldLab *world_lab);

// With what a kernel is built here.
const char *world_kernel_options(const World *world, const WorldKernel *kernel);

// 2D, of labs 01 and 03; 3D, of lab 04; and from lab 05 on.
extern const WorldKind CIRCLES;
extern const WorldKind RAYS;
extern const WorldKind SPHERES;

// The arguments of the labs' kernels.
void circles_set_naive(const World *world, cl_kernel kernel, cl_mem d_work);  // implicit2DRenderer
void circles_set_tree(const World *world, cl_kernel kernel, cl_mem d_work);   // ..._KD
void rays_set_directions(const World *world, cl_kernel kernel, cl_mem d_work);  // draw_directions
void spheres_set_naive(const World *world, cl_kernel kernel, cl_mem d_work);    // render_spheres
void spheres_set_tree(const World *world, cl_kernel kernel, cl_mem d_work);     // render_kdtree

// Lab 05's kernel, as later labs set it beside their own.
#define SPHERES_NAIVE_KERNEL                                                                       \
    {                                                                                              \
        .label = "naive",                                                                          \
        .path = "solutions/05-spheres/render_spheres.cl",                                          \
        .function = "render_spheres",                                                              \
        .options = KERNEL_OPTIONS,                                                                 \
        .steps_path = STEPS_FOLDER "/05-spheres.cl",                                               \
        .set_arguments = spheres_set_naive,                                                        \
    }

// Those that render_kdtree begins with, and all that trace its rays and more: 0 to 12.
void spheres_set_traced(const World *world, cl_kernel kernel);

// Memory for what a kind keeps, all zero. Running out of it ends the program with a message.
void *world_allocate(size_t n_bytes);

#endif
