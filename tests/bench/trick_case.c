// A scene of the bench of tricks (see trick_case.h).
//
// Read next: bench_tricks.c.
#include "trick_case.h"

#include "circle_tree.h"
#include "circles.h"
#include "cl_memory.h"
#include "complain.h"
#include "hidden_circles.h"
#include "launch.h"
#include "path.h"
#include "stats.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static const char *const SCENE_NAMES[N_PARTS][N_TRICK_SCENES] = {
    [CIRCLES] = {"random:min=2,max=20", "random:min=1,max=4", "random:min=10,max=60"},
    [SPHERES] = {"sphereflake", "random:n=100000", "random:n=1000000"},
};

static TileShape shape_of(const ClSetup *cl, Part part, const Trick *trick)
{
    return trick_shape(trick,
                       part == CIRCLES ? circle_tile_shape(cl->device) : tile_shape(cl->device));
}

cl_program trick_build(const ClSetup *cl, Part part, const Trick *trick, const char *folder)
{
    char path[PATH_MAX], options[PATH_MAX];
    path_make(path, "%s/tricks", folder);
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
        complain("bench_tricks: cannot make the folder %s: %s", path, strerror(errno));
        return NULL;
    }
    path_make(path, "%s/tricks/%s", folder, trick->name);
    if (trick_write(trick, path) != 0) {
        return NULL;
    }
    const TileShape shape = shape_of(cl, part, trick);
    // MIRRORS_OPTIONS comes from the Makefile: the folders of this lab and of those before it.
    snprintf(options, sizeof options, "%s -DLANES=%d -DTILE_WIDTH=%d -DTILE_HEIGHT=%d",
             MIRRORS_OPTIONS, shape.lanes, shape.width, shape.height);
    path_make(path, "%s/tricks/%s/%s", folder, trick->name, PART_TRICKS[part].program);
    return cl_setup_build(cl, path, options);
}

// ---- Preparing ------------------------------------------------------------------------------

// Copy a tree of circles to the device.
static void copy_tree(const CircleTree *tree, const ClSetup *cl, cl_mem *d_nodes,
                      cl_mem *d_leaf_circles)
{
    *d_nodes = cl_buffer_create(cl, tree->nodes, tree->n_nodes * sizeof *tree->nodes);
    *d_leaf_circles =
        cl_buffer_create(cl, tree->leaf_circles, tree->n_leaf_circles * sizeof *tree->leaf_circles);
}

// The trees of circles, without and with hidden ones, on the device. Returns 0, or -1 after one
// message.
static int prepare_trees(TrickCase *trick_case, const ClSetup *cl)
{
    const Scene2D *scene = &trick_case->circles;
    const KdTreeLimits limits = {OPTIONS_LARGEST_MAX_DEPTH, CIRCLE_LEAF_SIZE};
    const KdTreeLimits one_leaf = {1, scene->n_circles};
    CircleTree tree = {0}, circles = {0}, hidden = {0};
    int result = circle_tree_build(scene, limits, &tree);
    result = result == 0 ? circle_tree_build(scene, one_leaf, &circles) : -1;
    result = result == 0 ? hidden_circles_add(&tree, TRICK_SIDE, &circles, &hidden) : -1;
    if (result == 0) {
        copy_tree(&tree, cl, &trick_case->d_nodes, &trick_case->d_leaf_circles);
        copy_tree(&hidden, cl, &trick_case->d_hidden_nodes, &trick_case->d_hidden_circles);
    }
    circle_tree_free(&tree);
    circle_tree_free(&circles);
    circle_tree_free(&hidden);
    return result;
}

// Returns 0, or -1 after one message.
static int prepare_circles(TrickCase *trick_case, const ClSetup *cl)
{
    if (scene2d_open(trick_case->scene_name, TRICK_SIDE, TRICK_SIDE, &trick_case->circles) != 0 ||
        cl_image_create(cl, TRICK_SIDE, TRICK_SIDE, &trick_case->d_image) != 0 ||
        prepare_trees(trick_case, cl) != 0) {
        return -1;
    }
    trick_case->d_pixels = pixels_create(cl, TRICK_SIDE, TRICK_SIDE);
    return 0;
}

// The arguments, in the order of the kernel's parameter list.
static void set_circles(const TrickCase *trick_case, const Trick *trick, cl_kernel kernel)
{
    const cl_int side = TRICK_SIDE;
    const int hidden = trick->has_hidden_circles;
    const cl_mem tree[] = {hidden ? trick_case->d_hidden_nodes : trick_case->d_nodes,
                           hidden ? trick_case->d_hidden_circles : trick_case->d_leaf_circles};
    kernel_set_buffers(kernel, 0, tree, 2);
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof side, &side));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof side, &side));
    kernel_set_buffers(kernel, 4, trick->has_image ? &trick_case->d_image : &trick_case->d_pixels,
                       1);
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof(cl_mem), NULL));  // nothing is counted
}

// Returns 0, or -1 after one message.
static int prepare_spheres(TrickCase *trick_case, const ClSetup *cl)
{
    Lab lab = {.name = "bench_tricks", .cl = *cl};
    Scene3D *scene = &trick_case->spheres;
    int result = scene3d_open(trick_case->scene_name, TRICK_SIDE, TRICK_SIDE, scene);
    result = result == 0 ? tile_buffers_create(&lab, scene, &trick_case->tiles) : -1;
    lab.options.leaf_size = 1;
    result = result == 0 ? tile_buffers_create(&lab, scene, &trick_case->small_leaves) : -1;
    stats_free(&lab.stats);
    return result;
}

// Whose tree and picture a kernel takes.
static const TileBuffers *buffers_of(const TrickCase *trick_case, const Trick *trick)
{
    return trick->has_small_leaves ? &trick_case->small_leaves : &trick_case->tiles;
}

static void set_spheres(const TrickCase *trick_case, const Trick *trick, cl_kernel kernel)
{
    const TileBuffers *buffers = buffers_of(trick_case, trick);
    tile_buffers_set(buffers, &trick_case->spheres, kernel);
    if (trick->in_scene_order) {
        CL_CHECK(clSetKernelArg(kernel, 13, sizeof(cl_mem), &buffers->scene.d_spheres));
    }
    CL_CHECK(clSetKernelArg(kernel, 14, sizeof(cl_mem), NULL));  // nothing is counted
}

int trick_case_prepare(TrickCase *trick_case, const ClSetup *cl, Part part, int scene,
                       const cl_program *programs)
{
    trick_case->part = part;
    trick_case->scene_name = SCENE_NAMES[part][scene];
    if ((part == CIRCLES ? prepare_circles : prepare_spheres)(trick_case, cl) != 0) {
        return -1;
    }
    for (int i = 0; i < PART_TRICKS[part].n_tricks; i++) {
        const Trick *trick = &PART_TRICKS[part].tricks[i];
        trick_case->kernels[i] = kernel_create(programs[i], PART_TRICKS[part].kernel);
        trick_case->shapes[i] = shape_of(cl, part, trick);
        (part == CIRCLES ? set_circles : set_spheres)(trick_case, trick, trick_case->kernels[i]);
        trick_case_draw(trick_case, cl, i);
    }
    return 0;
}

void trick_case_free(TrickCase *trick_case)
{
    const cl_mem memory[] = {trick_case->d_nodes,        trick_case->d_leaf_circles,
                             trick_case->d_hidden_nodes, trick_case->d_hidden_circles,
                             trick_case->d_pixels,       trick_case->d_image};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    kernels_free(trick_case->kernels, MAX_TRICKS);
    tile_buffers_free(&trick_case->tiles);
    tile_buffers_free(&trick_case->small_leaves);
    scene2d_free(&trick_case->circles);
    scene3d_free(&trick_case->spheres);
}

// ---- Measuring ------------------------------------------------------------------------------

double trick_case_draw(const TrickCase *trick_case, const ClSetup *cl, int trick)
{
    const double start = stats_clock_ms();
    enqueue_tiles_of(cl->queue, trick_case->kernels[trick], trick_case->shapes[trick], TRICK_SIDE,
                     TRICK_SIDE);
    CL_CHECK(clFinish(cl->queue));
    return stats_clock_ms() - start;
}

// Where a kernel draws bytes.
static cl_mem pixels_of(const TrickCase *trick_case, int trick)
{
    return trick_case->part == CIRCLES
               ? trick_case->d_pixels
               : buffers_of(trick_case, &PART_TRICKS[SPHERES].tricks[trick])->d_pixels;
}

void trick_case_spoil(const TrickCase *trick_case, const ClSetup *cl, int trick)
{
    if (PART_TRICKS[trick_case->part].tricks[trick].has_image) {
        spoil_image(cl, trick_case->d_image, TRICK_SIDE, TRICK_SIDE);
        return;
    }
    const cl_uint no_color = 0x01020304;
    CL_CHECK(clEnqueueFillBuffer(cl->queue, pixels_of(trick_case, trick), &no_color,
                                 sizeof no_color, 0, sizeof no_color * TRICK_SIDE * TRICK_SIDE, 0,
                                 NULL, NULL));
}

void trick_case_read(const TrickCase *trick_case, const ClSetup *cl, int trick, Image *picture)
{
    if (PART_TRICKS[trick_case->part].tricks[trick].has_image) {
        read_image(cl, trick_case->d_image, picture);
    } else {
        pixels_read(cl->queue, pixels_of(trick_case, trick), picture);
    }
}
