// Whole frames with shadows and mirrors (see lit_frames.h).
//
// Read next: bench3d.c.
#include "lit_frames.h"

#include "launch.h"
#include "same_pictures.h"
#include "stats.h"

#include <stdio.h>

enum { FRAMES_A_ROUND = 2 };

static const int SIDES[N_LIT_SIDES] = {CASE3D_SIDE, CASE3D_SIDE / 2};

// The share of pixels that may differ, for each number of mirrors. A sphere that mirrors rays
// drives them apart, and so multiplies what rounding has done to each, until one hits another
// sphere: of a million pixels none was seen to differ on a CPU without a mirror, 22 with one and
// 181 with two; on a GPU 2, 45 and 292. The shares with mirrors are some two to five times that.
static const double AMBIGUOUS_SHARES[N_MIRROR_NUMBERS] = {MAX_AMBIGUOUS_SHARE, 1e-4, 1e-3};

// What no kernel draws: violet without opacity. What lab 09's does not draw is another colour
// (NEVER_DRAWN), so that two pictures that nobody has drawn differ.
#define NEVER_DRAWN_PIXEL 0x00ff00ffu

// ---- Preparing ------------------------------------------------------------------------------

// As the CSV file and messages call them.
static const char *const NAMES[N_LIT_RENDERERS] = {[LIT_RAYS] = "kd-tree", [LIT_TILES] = "tiles"};

// The kernels, by LitRenderer. MIRRORS_OPTIONS comes from the Makefile.
static KernelRow KERNELS[N_LIT_RENDERERS] = {
    [LIT_RAYS] = {"solutions/09-shadows-and-mirrors/render_mirrors.cl", MIRRORS_OPTIONS,
                  "render_mirrors"},
    // Its options depend on the device.
    [LIT_TILES] = {"solutions/10-realtime/render_lit_tiles.cl", NULL, "render_lit_tiles"},
};

// Set all arguments of a kernel, as the lab's main.c does.
static void set_arguments(const LitFrame *frame, LitRenderer renderer, const Case3D *bench_case)
{
    // The same scene and buffers for each size: a smaller picture leaves a part of them as it is.
    Scene3D scene = bench_case->scene;
    scene.width = scene.height = frame->side;
    cl_kernel kernel = frame->kernels[renderer];
    cl_uint next;
    if (renderer == LIT_TILES) {
        tile_buffers_set(&bench_case->tiles, &scene, kernel);
        next = 14;
    } else {
        scene_buffers_set(&bench_case->buffers, &scene, kernel);
        tree_buffers_set(&bench_case->trees[KDTREE], kernel);
        next = N_SCENE_ARGUMENTS + 3;
    }
    CL_CHECK(clSetKernelArg(kernel, next, sizeof frame->n_mirrors, &frame->n_mirrors));
    CL_CHECK(clSetKernelArg(kernel, next + 1, sizeof(cl_mem), NULL));  // nothing is counted
}

// Queue a frame, or a square part of it.
static void enqueue(const LitFrame *frame, const ClSetup *cl, LitRenderer renderer, int side)
{
    if (renderer == LIT_TILES) {
        enqueue_tiles(cl->queue, frame->kernels[renderer], side, side);
    } else {
        launch(cl, frame->kernels[renderer], 0, 0, side, side);
    }
}

int lit_frames_prepare(LitFrame frames[N_LIT_FRAMES], const ClSetup *cl, const Case3D *bench_case)
{
    cl_program programs[N_LIT_RENDERERS] = {NULL};
    KERNELS[LIT_TILES].options = tile_shape(cl->device).options;
    const int result = programs_build(cl, KERNELS, N_LIT_RENDERERS, programs);
    for (int i = 0; i < N_LIT_FRAMES && result == 0; i++) {
        LitFrame *frame = &frames[i];
        frame->side = SIDES[i / N_MIRROR_NUMBERS];
        frame->n_mirrors = i % N_MIRROR_NUMBERS;
        snprintf(frame->name, sizeof frame->name, "%s, %dx%d, mirrors: %d", bench_case->scene_name,
                 frame->side, frame->side, frame->n_mirrors);
        for (int renderer = 0; renderer < N_LIT_RENDERERS; renderer++) {
            frame->kernels[renderer] = kernel_create(programs[renderer], KERNELS[renderer].name);
            set_arguments(frame, renderer, bench_case);
            // The driver may compile at the first launch.
            enqueue(frame, cl, renderer, GROUP_SIZE);
        }
    }
    CL_CHECK(clFinish(cl->queue));
    programs_free(programs, N_LIT_RENDERERS);
    return result;
}

void lit_frames_free(LitFrame frames[N_LIT_FRAMES])
{
    for (int i = 0; i < N_LIT_FRAMES; i++) {
        kernels_free(frames[i].kernels, N_LIT_RENDERERS);
    }
}

// ---- Pictures -------------------------------------------------------------------------------

// Make each pixel what no kernel draws.
static void spoil_pictures(const ClSetup *cl, const Case3D *bench_case)
{
    const cl_uint never = NEVER_DRAWN_PIXEL;
    spoil_image(cl, bench_case->buffers.d_image, CASE3D_SIDE, CASE3D_SIDE);
    CL_CHECK(clEnqueueFillBuffer(cl->queue, bench_case->tiles.d_pixels, &never, sizeof never, 0,
                                 sizeof never * CASE3D_SIDE * CASE3D_SIDE, 0, NULL, NULL));
    CL_CHECK(clFinish(cl->queue));
}

// Compare the pictures that both have drawn. Returns 0, or -1 after one message.
static int check_pictures(const LitFrame *frame, const ClSetup *cl, const Case3D *bench_case,
                          Measurements *measurements)
{
    Image rays = {0}, tiles = {0};
    int result = image_create(frame->side, frame->side, &rays);
    if (result == 0) {
        result = image_create(frame->side, frame->side, &tiles);
    }
    if (result == 0) {
        read_image(cl, bench_case->buffers.d_image, &rays);
        round_to_bytes(&rays);
        pixels_read(cl->queue, bench_case->tiles.d_pixels, &tiles);
        const double share = AMBIGUOUS_SHARES[frame->n_mirrors];
        char names[128];
        snprintf(names, sizeof names, "bench3d: %s, tiles beside kd-tree", frame->name);
        const int n_different = pictures_compare(&tiles, &rays, BYTE_TOLERANCE,
                                                 (int)(share * frame->side * frame->side), names);
        measurements_add(measurements, frame->name, NAMES[LIT_TILES], "different", n_different);
        result = n_different >= 0 ? 0 : -1;
    }
    image_free(&rays);
    image_free(&tiles);
    return result;
}

// ---- Measuring ------------------------------------------------------------------------------

// A frame's times of a round.
static void measure_frame(const LitFrame *frame, const ClSetup *cl, LitRenderer renderer,
                          Measurements *measurements)
{
    for (int i = 0; i < FRAMES_A_ROUND; i++) {
        const double start = stats_clock_ms();
        enqueue(frame, cl, renderer, frame->side);
        CL_CHECK(clFinish(cl->queue));
        measurements_add(measurements, frame->name, NAMES[renderer], "frame",
                         stats_clock_ms() - start);
    }
}

int lit_frames_measure(LitFrame frames[N_LIT_FRAMES], const ClSetup *cl, const Case3D *bench_case,
                       Measurements *measurements)
{
    const int is_first = measurements->round == 0;
    for (int i = 0; i < N_LIT_FRAMES; i++) {
        if (is_first) {
            spoil_pictures(cl, bench_case);
        }
        for (int renderer = 0; renderer < N_LIT_RENDERERS; renderer++) {
            measure_frame(&frames[i], cl, renderer, measurements);
        }
        if (is_first && check_pictures(&frames[i], cl, bench_case, measurements) != 0) {
            return -1;
        }
    }
    return 0;
}
