// The world of labs 01 and 03: circles on a plane that is shifted and zoomed (see world.h).
//
// The kernels know pixels only: a pixel's sample point is its integer coordinate. So it is the
// circles that move, and the tree is built over the moved ones. All zooms are powers of two and all
// shifts whole pixels of the picture: this moves no digit of a float, and both kernels still draw
// the same.
// Read next: frame.h.
#include "cl_memory.h"
#include "scene2d.h"
#include "world.h"

#include <math.h>
#include <string.h>

// A pose's numbers.
enum { LEFT, TOP, ZOOM, N_NUMBERS };

static const f32 FARTHEST_ZOOM = -4, NEAREST_ZOOM = 6;
static const f32 PIXELS_A_SECOND = 480;

typedef struct Circles {
    Scene2D scene;
    Circle *moved;  // [scene.n_circles], as the pose shows them
    cl_mem d_circles;
    KdTree2D tree;
    cl_mem d_nodes_Relations, d_nodes_flag, d_nodes_BBox, d_mapNode2Circles;
} Circles;

// ---- The tree -------------------------------------------------------------------------------

static void tree_release(Circles *own)
{
    const cl_mem memory[] = {own->d_nodes_Relations, own->d_nodes_flag, own->d_nodes_BBox,
                             own->d_mapNode2Circles};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    tree2d_free(&own->tree);
}

static int circles_grow(World *world)
{
    Circles *own = world->own;
    const u32 n_circles = (u32)own->scene.n_circles;
    KdTree2D tree = {0};
    const double start = stats_clock_ms();
    const int result = world->tree->build.circles(own->moved, n_circles, world->limits, &tree);
    const double build_ms = stats_clock_ms() - start;
    // The kernel follows every id without asking.
    const int depth = result == 0 && tree2d_check(&tree, n_circles) == 0 ? tree2d_depth(&tree) : -1;
    if (depth < 0) {
        tree2d_free(&tree);
        return -1;
    }
    tree_release(own);
    const ClSetup *cl = &world->lab->cl;
    own->tree = tree;
    own->d_nodes_Relations =
        cl_buffer_create(cl, tree.nodes_Relations, tree.n_nodes * sizeof *tree.nodes_Relations);
    own->d_nodes_flag =
        cl_buffer_create(cl, tree.nodes_flag, tree.n_nodes * sizeof *tree.nodes_flag);
    own->d_nodes_BBox =
        cl_buffer_create(cl, tree.nodes_BBox, tree.n_nodes * sizeof *tree.nodes_BBox);
    own->d_mapNode2Circles =
        cl_buffer_create(cl, tree.mapNode2Circles, tree.n_map * sizeof *tree.mapNode2Circles);
    world->figures = (TreeFigures){tree.n_nodes, tree.n_map, depth, build_ms};
    return 0;
}

// ---- Opening, looking, moving ---------------------------------------------------------------

static void circles_close(World *world)
{
    Circles *own = world->own;
    if (own != NULL) {
        tree_release(own);
        cl_memory_release(&own->d_circles, 1);
        cl_memory_release(&world->d_image, 1);
        free(own->moved);
        scene2d_free(&own->scene);
    }
    free(own);
    world->own = NULL;
}

// Copy the circles to the device, as the pose shows them.
static void circles_copy(World *world)
{
    Circles *own = world->own;
    const f32 *pose = world->pose.numbers;
    const f32 scale = exp2f(pose[ZOOM]);
    for (int i = 0; i < own->scene.n_circles; i++) {
        Circle circle = own->scene.circles[i];
        circle.x = (circle.x - pose[LEFT]) * scale;
        circle.y = (circle.y - pose[TOP]) * scale;
        circle.radius *= scale;
        own->moved[i] = circle;
    }
    cl_memory_release(&own->d_circles, 1);
    own->d_circles = cl_buffer_create(&world->lab->cl, own->moved,
                                      (size_t)own->scene.n_circles * sizeof *own->moved);
}

static int circles_place(World *world)
{
    circles_copy(world);
    return world->tree != NULL ? circles_grow(world) : 0;
}

static int circles_open(World *world)
{
    const Options *options = &world->lab->options;
    Circles *own = world->own = world_allocate(sizeof *own);
    if (scene2d_open(options->scene, options->width, options->height, &own->scene) != 0) {
        return -1;
    }
    world->width = own->scene.width;
    world->height = own->scene.height;
    world->n_elements = own->scene.n_circles;
    own->moved = world_allocate(((size_t)world->n_elements + 1) * sizeof *own->moved);
    circles_copy(world);
    return cl_image_create(&world->lab->cl, world->width, world->height, &world->d_image);
}

// Zoom by powers of two about the picture's middle.
static void zoom(World *world, int notches)
{
    f32 *pose = world->pose.numbers;
    const f32 zoomed = fminf(fmaxf(pose[ZOOM] + (f32)notches, FARTHEST_ZOOM), NEAREST_ZOOM);
    const f32 gained = exp2f(-pose[ZOOM]) - exp2f(-zoomed);  // pixels of the scene each pixel loses
    pose[LEFT] += gained * (f32)(world->width / 2);
    pose[TOP] += gained * (f32)(world->height / 2);
    pose[ZOOM] = zoomed;
}

static void circles_move(World *world, Motion motion)
{
    f32 *pose = world->pose.numbers;
    if (motion.notches != 0) {
        zoom(world, motion.notches);
    }
    const f32 pixel = exp2f(-pose[ZOOM]);  // of the picture, in pixels of the scene
    pose[LEFT] += pixel * roundf(PIXELS_A_SECOND * motion.right - motion.drag_right);
    pose[TOP] -= pixel * roundf(PIXELS_A_SECOND * motion.forward + motion.drag_down);
}

// A circle on the plane: a quarter of the picture's height wide.
static Pose circles_film_pose(const World *world, int frame, int n_frames)
{
    const double angle = 2 * M_PI * frame / n_frames;
    const f32 radius = (f32)world->height / 8;
    Pose pose = world->home;
    pose.numbers[LEFT] += roundf(radius * (f32)sin(angle));
    pose.numbers[TOP] += roundf(radius * (f32)(cos(angle) - 1));
    return pose;
}

static int circles_find(const World *world, const f32 *element, int start)
{
    const Circles *own = world->own;
    for (int i = 0; i < world->n_elements; i++) {
        const int id = (start + i) % world->n_elements;
        const Circle circle = own->moved[id];
        if (circle.x == element[0] && circle.y == element[1] && circle.radius == element[2] &&
            circle.depth == element[3]) {
            return id;
        }
    }
    return -1;
}

static WorldData circles_data(const World *world)
{
    const Circles *own = world->own;
    return (WorldData){.circles = own->moved, .tree2d = world->tree != NULL ? &own->tree : NULL};
}

const WorldKind CIRCLES = {
    .set = OPTIONS_SCENE,
    .n_numbers = N_NUMBERS,
    .pose_line = "left, top, zoom (a power of two)",
    .elements = "circles",
    .askers = "pixels",
    .open = circles_open,
    .close = circles_close,
    .place = circles_place,
    .grow = circles_grow,
    .move = circles_move,
    .film_pose = circles_film_pose,
    .find = circles_find,
    .data = circles_data,
};

// ---- The kernels' arguments -----------------------------------------------------------------

void circles_set_naive(const World *world, cl_kernel kernel, cl_mem d_work)
{
    const Circles *own = world->own;
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof own->d_circles, &own->d_circles));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof own->scene.n_circles, &own->scene.n_circles));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof world->width, &world->width));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof world->height, &world->height));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof world->d_image, &world->d_image));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof d_work, &d_work));
}

void circles_set_tree(const World *world, cl_kernel kernel, cl_mem d_work)
{
    const Circles *own = world->own;
    const cl_mem tree[] = {own->d_nodes_Relations, own->d_nodes_flag, own->d_nodes_BBox,
                           own->d_mapNode2Circles};
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof own->d_circles, &own->d_circles));
    for (cl_uint i = 0; i < sizeof tree / sizeof *tree; i++) {
        CL_CHECK(clSetKernelArg(kernel, 1 + i, sizeof tree[i], &tree[i]));
    }
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof world->width, &world->width));
    CL_CHECK(clSetKernelArg(kernel, 6, sizeof world->height, &world->height));
    CL_CHECK(clSetKernelArg(kernel, 7, sizeof world->d_image, &world->d_image));
    CL_CHECK(clSetKernelArg(kernel, 8, sizeof d_work, &d_work));
}
