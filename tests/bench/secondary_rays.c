// Lab 09's shadow rays and first mirrored ones (see secondary_rays.h).
//
// Read next: secondary_rays.cl, shadow_tiles.c, embree_rays.c.
#include "secondary_rays.h"

#include "cl_memory.h"
#include "complain.h"
#include "launch.h"
#include "same_pictures.h"
#include "stats.h"

#include <stdlib.h>

enum { N_PIXELS = CASE3D_SIDE * CASE3D_SIDE, SEARCHES_A_ROUND = 5 };

// How many work-items stand in a group: as many as in the labs.
enum { GROUP_ITEMS = GROUP_SIZE * GROUP_SIZE };

// What no search answers: it is no number of a sphere, and not NO_SPHERE.
#define NEVER_ANSWERED 0xfffffffeu

static const char *const KERNELS[N_RAY_KINDS] = {
    [SHADOW_RAYS] = "search_shadow",
    [MIRRORED_RAYS] = "search_mirrored",
};

// As the CSV file and messages call the rays of the sphereflake, and what searches them.
static const char *const RAY_NAMES[N_RAY_KINDS] = {
    [SHADOW_RAYS] = "shadow rays",
    [MIRRORED_RAYS] = "mirrored rays",
};
static const char *const SEARCHER_NAMES[N_RAY_KINDS][N_SEARCHERS] = {
    [SHADOW_RAYS] = {"kd-tree", "tiles", "rtcOccluded1", "rtcOccluded4", "rtcOccluded8",
                     "rtcOccluded16", "rtcOccluded1M"},
    [MIRRORED_RAYS] = {"kd-tree", NULL, "rtcIntersect1", "rtcIntersect4", "rtcIntersect8",
                       "rtcIntersect16", "rtcIntersect1M"},
};

// ---- Making ---------------------------------------------------------------------------------

static cl_mem create_buffer(const ClSetup *cl, size_t n_bytes)
{
    cl_int error;
    cl_mem d_buffer = clCreateBuffer(cl->context, CL_MEM_READ_WRITE, n_bytes, NULL, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    return d_buffer;
}

// Make one ray a pixel and append those that are there.
//   light   as make_rays takes it
static void append_rays(RayList *list, const ClSetup *cl, cl_kernel make_rays, int light,
                        cl_mem d_made)
{
    CL_CHECK(clSetKernelArg(make_rays, 13, sizeof light, &light));
    CL_CHECK(clSetKernelArg(make_rays, 14, sizeof d_made, &d_made));
    launch(cl, make_rays, 0, 0, CASE3D_SIDE, CASE3D_SIDE);
    cl_int error;
    const SecondaryRay *h_made =
        clEnqueueMapBuffer(cl->queue, d_made, CL_TRUE, CL_MAP_READ, 0, N_PIXELS * sizeof *h_made, 0,
                           NULL, NULL, &error);
    CL_CHECK_CREATED(error, clEnqueueMapBuffer);
    for (int i = 0; i < N_PIXELS; i++) {
        if (h_made[i].t_max > 0) {
            list->rays[list->n_rays++] = h_made[i];
        }
    }
    CL_CHECK(clEnqueueUnmapMemObject(cl->queue, d_made, (void *)h_made, 0, NULL, NULL));
}

// Make the rays of one kind.
//   light_starts   out, of shadow rays: see ShadowTiles
// Returns 0, or -1 after one message.
static int make_list(RayList *list, const ClSetup *cl, const Case3D *bench_case, cl_program program,
                     RayKind kind, int *light_starts)
{
    const int n_lights = bench_case->scene.n_lights;
    const size_t most = (size_t)(kind == SHADOW_RAYS ? n_lights : 1) * N_PIXELS;
    list->rays = malloc(most * sizeof *list->rays);
    if (list->rays == NULL) {
        complain("bench3d: no memory for rays");
        return -1;
    }
    cl_kernel make_rays = kernel_create(program, "make_rays");
    scene_buffers_set(&bench_case->buffers, &bench_case->scene, make_rays);
    tree_buffers_set(&bench_case->trees[KDTREE], make_rays);
    cl_mem d_made = create_buffer(cl, N_PIXELS * sizeof(SecondaryRay));
    if (kind == MIRRORED_RAYS) {
        append_rays(list, cl, make_rays, n_lights, d_made);
    }
    for (int light = 0; kind == SHADOW_RAYS && light < n_lights; light++) {
        append_rays(list, cl, make_rays, light, d_made);
        light_starts[light + 1] = list->n_rays;
    }
    CL_CHECK(clReleaseMemObject(d_made));
    CL_CHECK(clReleaseKernel(make_rays));
    return 0;
}

// ---- Preparing ------------------------------------------------------------------------------

static void set_arguments(const RayList *list, const Case3D *bench_case)
{
    const TreeBuffers *tree = &bench_case->trees[KDTREE];
    const cl_mem buffers[] = {bench_case->buffers.d_spheres, tree->d_nodes, tree->d_sphere_ids};
    kernel_set_buffers(list->kernel, 0, buffers, 3);
    CL_CHECK(clSetKernelArg(list->kernel, 3, sizeof tree->bounds, &tree->bounds));
    kernel_set_buffers(list->kernel, 4, &list->d_rays, 1);
    CL_CHECK(clSetKernelArg(list->kernel, 5, sizeof list->n_rays, &list->n_rays));
    kernel_set_buffers(list->kernel, 6, &list->d_answers, 1);
}

// Search the first n_rays rays, rounded up to whole work-groups, and wait for the answers.
static void search(const RayList *list, const ClSetup *cl, int n_rays)
{
    const size_t local_size = GROUP_ITEMS;
    const size_t global_size = ((size_t)n_rays + GROUP_ITEMS - 1) / GROUP_ITEMS * GROUP_ITEMS;
    CL_CHECK(clEnqueueNDRangeKernel(cl->queue, list->kernel, 1, NULL, &global_size, &local_size, 0,
                                    NULL, NULL));
    CL_CHECK(clFinish(cl->queue));
}

// All that the searches of one kind need. Returns 0, or -1 after one message.
static int prepare_list(RayList *list, const ClSetup *cl, const Case3D *bench_case,
                        cl_program program, RayKind kind, int *light_starts)
{
    if (make_list(list, cl, bench_case, program, kind, light_starts) != 0) {
        return -1;
    }
    const size_t n_bytes = (size_t)list->n_rays * sizeof *list->answers;
    list->answers = malloc(n_bytes);
    list->other_answers = malloc(n_bytes);
    if (list->answers == NULL || list->other_answers == NULL) {
        complain("bench3d: no memory for answers");
        return -1;
    }
    list->d_rays = cl_buffer_create(cl, list->rays, (size_t)list->n_rays * sizeof *list->rays);
    list->d_answers = create_buffer(cl, n_bytes);
    list->kernel = kernel_create(program, KERNELS[kind]);
    set_arguments(list, bench_case);
    // The driver may compile at the first launch.
    search(list, cl, GROUP_ITEMS);
    return 0;
}

int secondary_rays_prepare(SecondaryRays *secondary, const ClSetup *cl, const Case3D *bench_case)
{
    const size_t n_starts = (size_t)bench_case->scene.n_lights + 1;
    secondary->light_starts = calloc(n_starts, sizeof *secondary->light_starts);
    if (secondary->light_starts == NULL) {
        complain("bench3d: no memory for lights");
        return -1;
    }
    // MIRRORS_OPTIONS comes from the Makefile.
    cl_program program = cl_setup_build(cl, "tests/bench/secondary_rays.cl", MIRRORS_OPTIONS);
    if (program == NULL) {
        return -1;
    }
    int result = 0;
    for (int kind = 0; kind < N_RAY_KINDS && result == 0; kind++) {
        result = prepare_list(&secondary->lists[kind], cl, bench_case, program, kind,
                              secondary->light_starts);
    }
    CL_CHECK(clReleaseProgram(program));
    if (result == 0) {
        const RayList *list = &secondary->lists[SHADOW_RAYS];
        result = shadow_tiles_prepare(&secondary->tiles, cl, bench_case, secondary->light_starts,
                                      list->d_rays, list->d_answers);
    }
    return result;
}

void secondary_rays_free(SecondaryRays *secondary)
{
    for (int kind = 0; kind < N_RAY_KINDS; kind++) {
        RayList *list = &secondary->lists[kind];
        const cl_mem memory[] = {list->d_rays, list->d_answers};
        cl_memory_release(memory, sizeof memory / sizeof *memory);
        kernels_free(&list->kernel, 1);
        free(list->rays);
        free(list->answers);
        free(list->other_answers);
    }
    shadow_tiles_free(&secondary->tiles);
    free(secondary->light_starts);
}

// ---- Answers --------------------------------------------------------------------------------

static void spoil_answers(const RayList *list, const ClSetup *cl)
{
    const u32 never = NEVER_ANSWERED;
    CL_CHECK(clEnqueueFillBuffer(cl->queue, list->d_answers, &never, sizeof never, 0,
                                 (size_t)list->n_rays * sizeof never, 0, NULL, NULL));
    CL_CHECK(clFinish(cl->queue));
}

// Keep a kernel's answers.
//   answers   out: one for each ray
// Returns 0, or -1 after one message: there is not one for each ray.
static int read_answers(const RayList *list, const ClSetup *cl, RayKind kind, Searcher searcher,
                        u32 *answers)
{
    CL_CHECK(clEnqueueReadBuffer(cl->queue, list->d_answers, CL_TRUE, 0,
                                 (size_t)list->n_rays * sizeof *answers, answers, 0, NULL, NULL));
    int n_missing = 0;
    for (int i = 0; i < list->n_rays; i++) {
        n_missing += answers[i] == NEVER_ANSWERED;
    }
    if (list->n_rays > 0 && n_missing == 0) {
        return 0;
    }
    complain("bench3d: %s, %s: found %d of %d without an answer, expected none", RAY_NAMES[kind],
             SEARCHER_NAMES[kind][searcher], n_missing, list->n_rays);
    return -1;
}

// Compare a searcher's answers, the other ones, with lab 09's. Returns 0, or -1 after one message.
static int check_answers(const RayList *list, RayKind kind, Searcher searcher,
                         Measurements *measurements)
{
    int n_different = 0;
    for (int i = 0; i < list->n_rays; i++) {
        n_different += list->other_answers[i] != list->answers[i];
    }
    measurements_add(measurements, RAY_NAMES[kind], SEARCHER_NAMES[kind][searcher], "different",
                     n_different);
    const int most = (int)(MAX_AMBIGUOUS_SHARE * list->n_rays);
    if (n_different <= most) {
        return 0;
    }
    complain("bench3d: %s: found %d of %d answers different between %s and %s, expected at "
             "most %d",
             RAY_NAMES[kind], n_different, list->n_rays, SEARCHER_NAMES[kind][LAB_09],
             SEARCHER_NAMES[kind][searcher], most);
    return -1;
}

// ---- Measuring ------------------------------------------------------------------------------

// Add a time for all rays, from `start` until now.
static void add_search(Measurements *measurements, RayKind kind, Searcher searcher, double start)
{
    measurements_add(measurements, RAY_NAMES[kind], SEARCHER_NAMES[kind][searcher], "search",
                     stats_clock_ms() - start);
}

static int measure_kernel(SecondaryRays *secondary, const ClSetup *cl, RayKind kind,
                          Searcher searcher, Measurements *measurements)
{
    RayList *list = &secondary->lists[kind];
    if (measurements->round == 0) {
        spoil_answers(list, cl);
    }
    for (int i = 0; i < SEARCHES_A_ROUND; i++) {
        const double start = stats_clock_ms();
        if (searcher == LAB_10) {
            shadow_tiles_search(&secondary->tiles, cl);
        } else {
            search(list, cl, list->n_rays);
        }
        add_search(measurements, kind, searcher, start);
    }
    if (measurements->round > 0) {
        return 0;
    }
    if (searcher == LAB_09) {
        measurements_add(measurements, RAY_NAMES[kind], "", "rays", list->n_rays);
        return read_answers(list, cl, kind, searcher, list->answers);
    }
    const int result = read_answers(list, cl, kind, searcher, list->other_answers);
    return result == 0 ? check_answers(list, kind, searcher, measurements) : result;
}

static int measure_call(RayList *list, EmbreePeer *peer, RayKind kind, EmbreeCall call,
                        Measurements *measurements)
{
    const Searcher searcher = EMBREE_SEARCHES + call;
    const int is_first = measurements->round == 0;
    for (int i = 0; is_first && i < list->n_rays; i++) {
        list->other_answers[i] = NEVER_ANSWERED;
    }
    for (int i = 0; i < SEARCHES_A_ROUND; i++) {
        const double start = stats_clock_ms();
        embree_peer_search(peer, call, kind, list->rays, list->n_rays, list->other_answers);
        add_search(measurements, kind, searcher, start);
    }
    return is_first ? check_answers(list, kind, searcher, measurements) : 0;
}

int secondary_rays_measure(SecondaryRays *secondary, const ClSetup *cl, const Case3D *bench_case,
                           int n_threads, Measurements *measurements)
{
    double build_ms;
    EmbreePeer *peer = NULL;
    if (n_threads > 0) {
        peer = embree_peer_new(&bench_case->scene, n_threads, &build_ms);
        if (peer == NULL) {
            return -1;
        }
    }
    int result = 0;
    for (int kind = 0; kind < N_RAY_KINDS && result == 0; kind++) {
        result = measure_kernel(secondary, cl, kind, LAB_09, measurements);
        if (kind == SHADOW_RAYS && result == 0) {
            result = measure_kernel(secondary, cl, kind, LAB_10, measurements);
        }
        for (int call = 0; call < N_EMBREE_CALLS && peer != NULL && result == 0; call++) {
            if (embree_peer_has(call)) {
                result = measure_call(&secondary->lists[kind], peer, kind, call, measurements);
            }
        }
    }
    embree_peer_free(peer);
    return result;
}
