// What the bench measures (see case2d.h).
#include "case2d.h"

#include "circles.h"
#include "cl_memory.h"
#include "complain.h"
#include "kdtree2d_build.h"
#include "launch.h"
#include "peers2d.h"
#include "stats.h"

#include <stdlib.h>
#include <string.h>

const char *const CASE2D_NAMES[N_CASE2D_KINDS] = {"naive", "kd-tree", "tiles", "painter", "cairo"};

// NAIVE_OPTIONS and KDTREE_OPTIONS come from the Makefile, as KERNEL_OPTIONS does in the labs.
static KernelRow KERNELS[N_CASE2D_KINDS] = {
    [NAIVE] = {"solutions/01-naive-2d/implicit2DRenderer.cl", NAIVE_OPTIONS, "implicit2DRenderer"},
    [KDTREE] = {"solutions/03-kdtree-2d-render/implicit2DRenderer_KD.cl", KDTREE_OPTIONS,
                "implicit2DRenderer_KD"},
    // Its options depend on the device.
    [TILES] = {"solutions/10-realtime/render_circles.cl", NULL, "render_circles"},
};

int programs2d_build(const ClSetup *cl, cl_program programs[N_CASE2D_KINDS])
{
    KERNELS[TILES].options = circle_tile_shape(cl->device).options;
    return programs_build(cl, KERNELS, N_CASE2D_KINDS, programs);
}

static const KdTreeLimits USUAL_LIMITS = {OPTIONS_DEFAULT_MAX_DEPTH, OPTIONS_DEFAULT_LEAF_SIZE};

// Build the tree and copy it to the device. Returns 0, or -1 after one message.
static int prepare_tree(Case2D *bench_case, const ClSetup *cl)
{
    const u32 n_circles = (u32)bench_case->scene->n_circles;
    KdTree2D tree = {0};
    if (kdtree2d_build(bench_case->scene->circles, n_circles, USUAL_LIMITS, &tree) != 0) {
        return -1;
    }
    if (tree2d_check(&tree, n_circles) != 0) {
        tree2d_free(&tree);
        return -1;
    }
    const cl_mem buffers[] = {
        bench_case->buffers[0],
        cl_buffer_create(cl, tree.nodes_Relations, tree.n_nodes * sizeof *tree.nodes_Relations),
        cl_buffer_create(cl, tree.nodes_flag, tree.n_nodes * sizeof *tree.nodes_flag),
        cl_buffer_create(cl, tree.nodes_BBox, tree.n_nodes * sizeof *tree.nodes_BBox),
        cl_buffer_create(cl, tree.mapNode2Circles, tree.n_map * sizeof *tree.mapNode2Circles)};
    memcpy(bench_case->buffers, buffers, sizeof buffers);
    tree2d_free(&tree);
    return 0;
}

// The tree of a TILES case, and its picture. Returns 0, or -1 after one message.
static int prepare_tiles(Case2D *bench_case, const ClSetup *cl)
{
    const KdTreeLimits limits = {OPTIONS_LARGEST_MAX_DEPTH, CIRCLE_LEAF_SIZE};
    CircleTree tree;
    if (circle_tree_build(bench_case->scene, limits, &tree) != 0) {
        return -1;
    }
    bench_case->buffers[0] = cl_buffer_create(cl, tree.nodes, tree.n_nodes * sizeof *tree.nodes);
    bench_case->buffers[1] =
        cl_buffer_create(cl, tree.leaf_circles, tree.n_leaf_circles * sizeof *tree.leaf_circles);
    bench_case->d_pixels = pixels_create(cl, bench_case->scene->width, bench_case->scene->height);
    circle_tree_free(&tree);
    return 0;
}

// What the peers draw, and where. Returns 0, or -1 after one message.
static int prepare_peer(Case2D *bench_case, const ClSetup *cl)
{
    const Scene2D *scene = bench_case->scene;
    const KdTreeLimits one_leaf = {1, scene->n_circles};
    if (circle_tree_build(scene, one_leaf, &bench_case->circles) != 0) {
        return -1;
    }
    bench_case->n_threads = device_is_cpu(cl) ? device_units(cl) : 1;
    bench_case->h_pixels =
        malloc((size_t)scene->width * (size_t)scene->height * sizeof *bench_case->h_pixels);
    if (bench_case->h_pixels == NULL) {
        complain("bench2d: no memory for a picture of %dx%d pixels", scene->width, scene->height);
        return -1;
    }
    return 0;
}

// Draw a peer's picture. It was tried in case2d_prepare().
static int draw_peer(const Case2D *bench_case)
{
    const Circles circles = {bench_case->circles.leaf_circles, bench_case->circles.n_leaf_circles};
    const int width = bench_case->scene->width, height = bench_case->scene->height;
    if (bench_case->kind == CAIRO) {
        return cairo_peer_draw(circles, width, height, bench_case->h_pixels);
    }
    painter_draw(circles, width, height, bench_case->n_threads, bench_case->h_pixels);
    return 0;
}

static int is_peer(const Case2D *bench_case)
{
    return KERNELS[bench_case->kind].path == NULL;
}

void case2d_read_bytes(const Case2D *bench_case, const ClSetup *cl, Image *picture)
{
    if (is_peer(bench_case)) {
        pixels_unpack(bench_case->h_pixels, picture);
    } else {
        pixels_read(cl->queue, bench_case->d_pixels, picture);
    }
}

// The arguments, in the order of each kernel's parameter list.
static void set_arguments(const Case2D *bench_case, cl_mem d_image)
{
    cl_kernel kernel = bench_case->kernel;
    const Scene2D *scene = bench_case->scene;
    const cl_mem picture = bench_case->kind == TILES ? bench_case->d_pixels : d_image;
    int n_buffers = 0;
    while (n_buffers < MAX_BUFFERS && bench_case->buffers[n_buffers] != NULL) {
        n_buffers++;
    }
    cl_uint next = kernel_set_buffers(kernel, 0, bench_case->buffers, n_buffers);
    if (bench_case->kind == NAIVE) {
        CL_CHECK(clSetKernelArg(kernel, next++, sizeof scene->n_circles, &scene->n_circles));
    }
    CL_CHECK(clSetKernelArg(kernel, next++, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, next++, sizeof scene->height, &scene->height));
    next = kernel_set_buffers(kernel, next, &picture, 1);
    CL_CHECK(clSetKernelArg(kernel, next, sizeof(cl_mem), NULL));  // nothing is counted
}

// Draw a part of the picture, from its top left corner on, and wait for it.
static void draw(const Case2D *bench_case, const ClSetup *cl, int width, int height)
{
    if (bench_case->kind == TILES) {
        enqueue_circle_tiles(cl->queue, bench_case->kernel, width, height);
    } else {
        launch(cl, bench_case->kernel, 0, 0, width, height);
    }
    CL_CHECK(clFinish(cl->queue));
}

int case2d_prepare(Case2D *bench_case, const ClSetup *cl, const cl_program *programs,
                   cl_mem d_image)
{
    const Scene2D *scene = bench_case->scene;
    if (is_peer(bench_case)) {
        return prepare_peer(bench_case, cl) == 0 ? draw_peer(bench_case) : -1;
    }
    bench_case->kernel = kernel_create(programs[bench_case->kind], KERNELS[bench_case->kind].name);
    if (bench_case->kind == NAIVE || bench_case->kind == KDTREE) {
        bench_case->buffers[0] =
            cl_buffer_create(cl, scene->circles, (size_t)scene->n_circles * sizeof *scene->circles);
    }
    if ((bench_case->kind == KDTREE && prepare_tree(bench_case, cl) != 0) ||
        (bench_case->kind == TILES && prepare_tiles(bench_case, cl) != 0)) {
        return -1;
    }
    set_arguments(bench_case, d_image);
    draw(bench_case, cl, GROUP_SIZE, GROUP_SIZE);
    return 0;
}

void case2d_free(Case2D *bench_case)
{
    cl_memory_release(bench_case->buffers, MAX_BUFFERS);
    cl_memory_release(&bench_case->d_pixels, 1);
    kernels_free(&bench_case->kernel, 1);
    circle_tree_free(&bench_case->circles);
    free(bench_case->h_pixels);
}

double case2d_draw(const Case2D *bench_case, const ClSetup *cl)
{
    const double start = stats_clock_ms();
    if (is_peer(bench_case)) {
        draw_peer(bench_case);
    } else {
        draw(bench_case, cl, bench_case->scene->width, bench_case->n_rows);
    }
    return (stats_clock_ms() - start) * bench_case->scene->height / bench_case->n_rows;
}
