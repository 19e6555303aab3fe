// A scene of the 3D bench (see case3d.h).
//
// Read next: pictures3d.c.
#include "case3d.h"

#include "cl_memory.h"
#include "kdtree3d_build.h"
#include "kdtree3d_sah.h"
#include "launch.h"
#include "stats.h"
#include "work_stats.h"

const char *const RENDERER_NAMES[N_RENDERERS] = {
    [NAIVE] = "naive",
    [KDTREE] = "kd-tree",
    [BY_COST] = "kd-tree by cost",
    [TILES] = "tiles",
    [EMBREE + EMBREE_1] = "rtcIntersect1",
    [EMBREE + EMBREE_4] = "rtcIntersect4",
    [EMBREE + EMBREE_8] = "rtcIntersect8",
    [EMBREE + EMBREE_16] = "rtcIntersect16",
    [EMBREE + EMBREE_STREAM] = "rtcIntersect1M",
};

// Sphere tests of a naive frame on a CPU, for each of its threads: one to three seconds' work.
#define TESTS_A_THREAD 1e9

// SPHERES_OPTIONS and TRACE_OPTIONS come from the Makefile, as KERNEL_OPTIONS does in the labs.
static KernelRow PROGRAMS[N_PROGRAMS] = {
    [NAIVE] = {"solutions/05-spheres/render_spheres.cl", SPHERES_OPTIONS, "render_spheres"},
    [KDTREE] = {"solutions/07-kdtree-3d-trace/render_kdtree.cl", TRACE_OPTIONS, "render_kdtree"},
    [BY_COST] = {"solutions/07-kdtree-3d-trace/render_kdtree.cl", TRACE_OPTIONS, "render_kdtree"},
    // Its options depend on the device.
    [TILES] = {"solutions/10-realtime/render_tiles.cl", NULL, "render_tiles"},
    [COUNTING] = {"solutions/07-kdtree-3d-trace/render_kdtree.cl", TRACE_OPTIONS " -DCOUNT_WORK",
                  "render_kdtree"},
};

int programs3d_build(const ClSetup *cl, cl_program programs[N_PROGRAMS])
{
    PROGRAMS[TILES].options = tile_shape(cl->device).options;
    return programs_build(cl, PROGRAMS, N_PROGRAMS, programs);
}

// ---- The naive kernel's share ---------------------------------------------------------------

enum { GROUPS_A_ROW = CASE3D_SIDE / GROUP_SIZE };  // and as many rows of work-groups

static Share choose_share(const ClSetup *cl, int n_spheres)
{
    const Share whole = {GROUPS_A_ROW, CASE3D_SIDE};
    if (!device_is_cpu(cl)) {
        return whole;
    }
    const double tests_a_group = (double)GROUP_SIZE * GROUP_SIZE * n_spheres;
    const int groups_a_thread = (int)(TESTS_A_THREAD / tests_a_group);
    // The same number for each thread, so that they end together.
    const double n_groups = (double)(groups_a_thread > 1 ? groups_a_thread : 1) * device_units(cl);
    if (n_groups >= GROUPS_A_ROW * GROUPS_A_ROW) {
        return whole;
    }
    if (n_groups >= GROUPS_A_ROW) {
        return (Share){(int)n_groups / GROUPS_A_ROW, CASE3D_SIDE};
    }
    return (Share){1, (int)n_groups * GROUP_SIZE};
}

int case3d_share_pixels(const Case3D *bench_case)
{
    return bench_case->share.n_stripes * GROUP_SIZE * bench_case->share.width;
}

static int share_is_whole(Share share)
{
    return share.n_stripes == GROUPS_A_ROW && share.width == CASE3D_SIDE;
}

// Where a stripe begins: in the middle of its part of the picture's height.
static int stripe_top(Share share, int stripe)
{
    return (2 * stripe + 1) * GROUPS_A_ROW / (2 * share.n_stripes) * GROUP_SIZE;
}

static int stripe_left(Share share)
{
    return (CASE3D_SIDE - share.width) / 2;
}

// ---- Preparing ------------------------------------------------------------------------------

// Those of lab 08's program: the cost knows by itself where to stop.
static const KdTreeLimits COST_LIMITS = {TODO_SIZE + 1, 1};

// Build the tree of KDTREE, BY_COST or TILES. Returns it, or a zeroed one after one message.
// Release with tree3d_free().
static KdTree3D build_tree(const Scene3D *scene, Renderer renderer)
{
    const u32 n_spheres = (u32)scene->n_spheres;
    KdTree3D tree = {0};
    if (renderer == KDTREE) {
        kdtree3d_build(scene->spheres, n_spheres, tree3d_limits(0, 0, n_spheres), &tree);
    } else {
        const KdTreeLimits limits = renderer == TILES ? tile_tree_limits(0, 0) : COST_LIMITS;
        kdtree3d_build_sah(scene->spheres, n_spheres, limits, &tree);
    }
    return tree;
}

// Copy a tree to the device, as lab 08's tree_buffers_create() does. Release with
// tree_buffers_free().
static TreeBuffers copy_tree(const KdTree3D *tree, const ClSetup *cl)
{
    return (TreeBuffers){
        .d_nodes = cl_buffer_create(cl, tree->nodes, tree->n_nodes * sizeof *tree->nodes),
        .d_sphere_ids =
            cl_buffer_create(cl, tree->sphere_ids, tree->n_sphere_ids * sizeof *tree->sphere_ids),
        .bounds = box_widened(tree->bounds)};
}

// Set a kernel's arguments behind the scene's.
static void set_tree(const TreeBuffers *buffers, cl_kernel kernel)
{
    tree_buffers_set(buffers, kernel);
    CL_CHECK(clSetKernelArg(kernel, N_SCENE_ARGUMENTS + 3, sizeof(cl_mem), NULL));  // no counting
}

// The tree of KDTREE or BY_COST, on the device, for its kernel. Returns 0, or -1 after one message.
static int prepare_tree(Case3D *bench_case, const ClSetup *cl, Renderer renderer)
{
    KdTree3D tree = build_tree(&bench_case->scene, renderer);
    int result = tree.n_nodes > 0 ? tree3d_check(&tree, (u32)bench_case->scene.n_spheres) : -1;
    if (result == 0) {
        bench_case->trees[renderer] = copy_tree(&tree, cl);
        set_tree(&bench_case->trees[renderer], bench_case->kernels[renderer]);
    }
    tree3d_free(&tree);
    return result;
}

// The tiles' tree and picture, and all arguments of their kernel. Returns 0, or -1 after one
// message.
static int prepare_tiles(Case3D *bench_case, const ClSetup *cl)
{
    Lab lab = {.name = "bench3d", .cl = *cl};
    const int result = tile_buffers_create(&lab, &bench_case->scene, &bench_case->tiles);
    stats_free(&lab.stats);
    if (result == 0) {
        cl_kernel kernel = bench_case->kernels[TILES];
        tile_buffers_set(&bench_case->tiles, &bench_case->scene, kernel);
        CL_CHECK(clSetKernelArg(kernel, 14, sizeof(cl_mem), NULL));  // nothing is counted
    }
    return result;
}

// Add the work of the rays side by side whose first pixel is (x, y) to a sum.
static void add_group(const Work *h_work, int x, int y, WorkOfRay *sum)
{
    u32 slowest = 0;
    for (int row = y; row < y + WORK_GROUP_HEIGHT; row++) {
        for (int column = x; column < x + WORK_GROUP_WIDTH; column++) {
            const Work *work = &h_work[row * CASE3D_SIDE + column];
            sum->n_nodes += work->n_nodes_visited;
            sum->n_leaves += work->n_leaves_visited;
            sum->n_tests += work->n_tests;
            slowest = work_steps(work) > slowest ? work_steps(work) : slowest;
        }
    }
    sum->n_slowest_steps += (double)slowest * WORK_GROUP_WIDTH * WORK_GROUP_HEIGHT;
}

// Draw a frame with lab 06's tree that counts, which is not timed.
static void count_work(Case3D *bench_case, const ClSetup *cl, cl_kernel counting)
{
    const double n_pixels = CASE3D_SIDE * CASE3D_SIDE;
    tree_buffers_set(&bench_case->trees[KDTREE], counting);
    cl_mem d_work = work_buffer_create(cl, CASE3D_SIDE, CASE3D_SIDE);
    CL_CHECK(clSetKernelArg(counting, N_SCENE_ARGUMENTS + 3, sizeof d_work, &d_work));
    launch(cl, counting, 0, 0, CASE3D_SIDE, CASE3D_SIDE);
    cl_int error;
    const Work *h_work =
        clEnqueueMapBuffer(cl->queue, d_work, CL_TRUE, CL_MAP_READ, 0,
                           sizeof *h_work * CASE3D_SIDE * CASE3D_SIDE, 0, NULL, NULL, &error);
    CL_CHECK_CREATED(error, clEnqueueMapBuffer);
    WorkOfRay sum = {0};
    for (int y = 0; y < CASE3D_SIDE; y += WORK_GROUP_HEIGHT) {
        for (int x = 0; x < CASE3D_SIDE; x += WORK_GROUP_WIDTH) {
            add_group(h_work, x, y, &sum);
        }
    }
    bench_case->work = (WorkOfRay){sum.n_nodes / n_pixels, sum.n_leaves / n_pixels,
                                   sum.n_tests / n_pixels, sum.n_slowest_steps / n_pixels};
    CL_CHECK(clEnqueueUnmapMemObject(cl->queue, d_work, (void *)h_work, 0, NULL, NULL));
    CL_CHECK(clReleaseMemObject(d_work));
}

static cl_kernel create_kernel(const Case3D *bench_case, const cl_program *programs, int program)
{
    cl_kernel kernel = kernel_create(programs[program], PROGRAMS[program].name);
    if (program != TILES) {
        scene_buffers_set(&bench_case->buffers, &bench_case->scene, kernel);
    }
    return kernel;
}

// The first work-groups. The naive one stands where its stripes do: drivers may compile launches
// with an offset anew.
static void run_first_groups(const Case3D *bench_case, const ClSetup *cl)
{
    const Share share = bench_case->share;
    const int whole = share_is_whole(share);
    launch(cl, bench_case->kernels[NAIVE], whole ? 0 : stripe_left(share),
           whole ? 0 : stripe_top(share, 0), GROUP_SIZE, GROUP_SIZE);
    launch(cl, bench_case->kernels[KDTREE], 0, 0, GROUP_SIZE, GROUP_SIZE);
    launch(cl, bench_case->kernels[BY_COST], 0, 0, GROUP_SIZE, GROUP_SIZE);
    enqueue_tiles(cl->queue, bench_case->kernels[TILES], GROUP_SIZE, GROUP_SIZE);
    CL_CHECK(clFinish(cl->queue));
}

int case3d_prepare(Case3D *bench_case, const ClSetup *cl, const cl_program *programs)
{
    Scene3D *scene = &bench_case->scene;
    if (scene3d_open(bench_case->scene_name, CASE3D_SIDE, CASE3D_SIDE, scene) != 0 ||
        scene_buffers_create(cl, scene, &bench_case->buffers) != 0) {
        return -1;
    }
    bench_case->share = choose_share(cl, scene->n_spheres);
    for (int i = 0; i < N_KERNELS; i++) {
        bench_case->kernels[i] = create_kernel(bench_case, programs, i);
    }
    cl_kernel naive = bench_case->kernels[NAIVE];
    CL_CHECK(clSetKernelArg(naive, N_SCENE_ARGUMENTS, sizeof scene->n_spheres, &scene->n_spheres));
    CL_CHECK(clSetKernelArg(naive, N_SCENE_ARGUMENTS + 1, sizeof(cl_mem), NULL));
    cl_kernel counting = create_kernel(bench_case, programs, COUNTING);
    int result = prepare_tree(bench_case, cl, KDTREE);
    if (result == 0) {
        count_work(bench_case, cl, counting);
        result = prepare_tree(bench_case, cl, BY_COST);
    }
    if (result == 0) {
        result = prepare_tiles(bench_case, cl);
    }
    if (result == 0) {
        run_first_groups(bench_case, cl);
    }
    CL_CHECK(clReleaseKernel(counting));
    return result;
}

void case3d_free(Case3D *bench_case)
{
    kernels_free(bench_case->kernels, N_KERNELS);
    tree_buffers_free(&bench_case->trees[KDTREE]);
    tree_buffers_free(&bench_case->trees[BY_COST]);
    tile_buffers_free(&bench_case->tiles);
    scene_buffers_free(&bench_case->buffers);
    scene3d_free(&bench_case->scene);
}

// ---- Measuring ------------------------------------------------------------------------------

double case3d_draw(const Case3D *bench_case, const ClSetup *cl, Renderer renderer)
{
    const Share share = bench_case->share;
    const int draws_share = renderer == NAIVE && !share_is_whole(share);
    const double n_pixels = (double)CASE3D_SIDE * CASE3D_SIDE;
    const double start = stats_clock_ms();
    if (renderer == TILES) {
        enqueue_tiles(cl->queue, bench_case->kernels[TILES], CASE3D_SIDE, CASE3D_SIDE);
    } else if (!draws_share) {
        launch(cl, bench_case->kernels[renderer], 0, 0, CASE3D_SIDE, CASE3D_SIDE);
    }
    for (int i = 0; draws_share && i < share.n_stripes; i++) {
        launch(cl, bench_case->kernels[renderer], stripe_left(share), stripe_top(share, i),
               share.width, GROUP_SIZE);
    }
    CL_CHECK(clFinish(cl->queue));
    const double ms = stats_clock_ms() - start;
    return draws_share ? ms * n_pixels / case3d_share_pixels(bench_case) : ms;
}

// Copy a tree to the device and throw the copy away. Returns the milliseconds.
static double time_copy(const KdTree3D *tree, const ClSetup *cl)
{
    const double start = stats_clock_ms();
    TreeBuffers buffers = copy_tree(tree, cl);
    // A driver may wait with copying until a kernel wants them.
    const cl_mem copies[] = {buffers.d_nodes, buffers.d_sphere_ids};
    CL_CHECK(clEnqueueMigrateMemObjects(cl->queue, 2, copies, 0, 0, NULL, NULL));
    CL_CHECK(clFinish(cl->queue));
    const double ms = stats_clock_ms() - start;
    tree_buffers_free(&buffers);
    return ms;
}

int case3d_time_tree(const Case3D *bench_case, const ClSetup *cl, Renderer renderer,
                     TreeTimes *times)
{
    const double start = stats_clock_ms();
    KdTree3D tree = build_tree(&bench_case->scene, renderer);
    times->build = stats_clock_ms() - start;
    if (tree.n_nodes == 0) {
        return -1;
    }
    times->copy = time_copy(&tree, cl);
    tree3d_free(&tree);
    return 0;
}
