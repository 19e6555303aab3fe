// Race of lab 10, for its leaderboard: lab 07's kernel with lab 06's tree and the submission's with
// the tree that lab 10 gives it draw the sphereflake in turn. No points depend on it.
//
// Both stand in one process, so that what else the machine does falls on both; the clock is read
// here, around the kernels. Read next: race_answers.h.
#include "race_answers.h"

#include "cl_memory.h"
#include "kdtree3d_build.h"
#include "lab.h"
#include "probe.h"
#include "render.h"
#include "scene3d.h"
#include "scene_buffers.h"
#include "tile_buffers.h"

#include <math.h>
#include <time.h>

// A frame of a GPU takes less than its launch: it draws several at once.
enum { GPU_FRAMES = 20 };

typedef struct Race {
    Probe probe;
    Scene3D scene;
    SceneBuffers buffers;  // of the reference
    cl_mem d_nodes, d_sphere_ids;
    TileBuffers tiles;  // of the submission
    cl_kernel kernels[N_RACERS];
    int is_cpu;
} Race;

// ---- Preparing ----------------------------------------------------------------------------------

static cl_kernel build_kernel(const Race *race, const char *path, const char *name,
                              const char *options)
{
    cl_program program = probe_build(&race->probe, path, options);
    cl_kernel kernel = probe_kernel(program, name);
    CL_CHECK(clReleaseProgram(program));  // the kernel keeps it
    return kernel;
}

static void prepare_reference(Race *race)
{
    const ClSetup *cl = &race->probe.cl;
    const u32 n_spheres = (u32)race->scene.n_spheres;
    KdTree3D tree;
    require(scene_buffers_create(cl, &race->scene, &race->buffers));
    require(kdtree3d_build(race->scene.spheres, n_spheres, tree3d_limits(0, 0, n_spheres), &tree));
    const BBox3D bounds = box_widened(tree.bounds);
    race->d_nodes = cl_buffer_create(cl, tree.nodes, tree.n_nodes * sizeof *tree.nodes);
    race->d_sphere_ids =
        cl_buffer_create(cl, tree.sphere_ids, tree.n_sphere_ids * sizeof *tree.sphere_ids);
    tree3d_free(&tree);
    cl_kernel kernel = build_kernel(race, "solutions/07-kdtree-3d-trace/render_kdtree.cl",
                                    "render_kdtree", PROBE_KERNEL_OPTIONS);
    cl_uint next = N_SCENE_ARGUMENTS;
    scene_buffers_set(&race->buffers, &race->scene, kernel);
    CL_CHECK(clSetKernelArg(kernel, next++, sizeof(cl_mem), &race->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, next++, sizeof(cl_mem), &race->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, next++, sizeof bounds, &bounds));
    CL_CHECK(clSetKernelArg(kernel, next, sizeof(cl_mem), NULL));  // nothing is counted
    race->kernels[RACE_REFERENCE] = kernel;
}

static void prepare_own(Race *race)
{
    Lab lab = {.name = "race", .cl = race->probe.cl};
    require(tile_buffers_create(&lab, &race->scene, &race->tiles));
    stats_free(&lab.stats);
    cl_kernel kernel = build_kernel(race, LAB_FOLDER "/render_tiles.cl", "render_tiles",
                                    tile_shape(race->probe.cl.device).options);
    tile_buffers_set(&race->tiles, &race->scene, kernel);
    CL_CHECK(clSetKernelArg(kernel, 14, sizeof(cl_mem), NULL));  // nothing is counted
    race->kernels[RACE_OWN] = kernel;
}

// ---- Drawing ------------------------------------------------------------------------------------

static void enqueue(const Race *race, Racer racer, int width, int height)
{
    EnqueuePixels *const enqueue_frame = racer == RACE_OWN ? enqueue_tiles : enqueue_pixels;
    enqueue_frame(race->probe.cl.queue, race->kernels[racer], width, height);
}

// On a CPU the processor time of this process, to which other programs add nothing; else the clock.
static double now_ms(const Race *race)
{
    struct timespec now;
    clock_gettime(race->is_cpu ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec / 1e6;
}

// Take the picture away that is there: nobody shall find the last round's.
static void clear_picture(const Race *race, Racer racer)
{
    const ClSetup *cl = &race->probe.cl;
    const cl_uint nothing[4] = {0};
    const size_t corner[3] = {0, 0, 0}, region[3] = {RACE_SIDE, RACE_SIDE, 1};
    if (racer == RACE_OWN) {
        CL_CHECK(clEnqueueFillBuffer(cl->queue, race->tiles.d_pixels, nothing, sizeof *nothing, 0,
                                     RACE_PICTURE_BYTES, 0, NULL, NULL));
    } else {
        CL_CHECK(clEnqueueFillImage(cl->queue, race->buffers.d_image, nothing, corner, region, 0,
                                    NULL, NULL));
    }
    CL_CHECK(clFinish(cl->queue));
}

// Draw, and return the milliseconds a frame.
static double draw(const Race *race, Racer racer)
{
    const int n_frames = race->is_cpu ? 1 : GPU_FRAMES;
    clear_picture(race, racer);
    const double start = now_ms(race);
    for (int i = 0; i < n_frames; i++) {
        enqueue(race, racer, RACE_SIDE, RACE_SIDE);
    }
    CL_CHECK(clFinish(race->probe.cl.queue));
    return (now_ms(race) - start) / n_frames;
}

static void run_rounds(const Race *race)
{
    RaceTimes times;
    for (Racer racer = 0; racer < N_RACERS; racer++) {
        // The driver finishes compiling where it meets the first work-group.
        enqueue(race, racer, GROUP_SIZE, GROUP_SIZE);
    }
    for (int round = 0; round < RACE_ROUNDS; round++) {
        for (Racer racer = 0; racer < N_RACERS; racer++) {
            times.ms[racer][round] = draw(race, racer);
        }
    }
    probe_answer(&race->probe, "times", -1, NULL, &times, sizeof times);
}

// ---- Pictures -----------------------------------------------------------------------------------

static u8 to_byte(float channel)
{
    return (u8)lrintf(fminf(fmaxf(channel, 0), 1) * 255);
}

// What each drew last, as bytes.
static void answer_pictures(const Race *race)
{
    static float channels[RACE_PICTURE_BYTES];
    static u8 bytes[RACE_PICTURE_BYTES];
    const cl_command_queue queue = race->probe.cl.queue;
    read_back(queue, race->buffers.d_image, RACE_SIDE, RACE_SIDE, channels);
    for (size_t i = 0; i < RACE_PICTURE_BYTES; i++) {
        bytes[i] = to_byte(channels[i]);
    }
    probe_answer(&race->probe, "picture", RACE_REFERENCE, NULL, bytes, sizeof bytes);
    CL_CHECK(clEnqueueReadBuffer(queue, race->tiles.d_pixels, CL_TRUE, 0, sizeof bytes, bytes, 0,
                                 NULL, NULL));
    probe_answer(&race->probe, "picture", RACE_OWN, NULL, bytes, sizeof bytes);
}

int main(void)
{
    static Race race;
    cl_device_type type;
    probe_open(&race.probe);
    probe_open_device(&race.probe);
    CL_CHECK(clGetDeviceInfo(race.probe.cl.device, CL_DEVICE_TYPE, sizeof type, &type, NULL));
    race.is_cpu = (type & CL_DEVICE_TYPE_CPU) != 0;
    require(scene3d_open("sphereflake", RACE_SIDE, RACE_SIDE, &race.scene));
    prepare_reference(&race);
    prepare_own(&race);
    run_rounds(&race);
    answer_pictures(&race);

    for (Racer racer = 0; racer < N_RACERS; racer++) {
        CL_CHECK(clReleaseKernel(race.kernels[racer]));
    }
    const cl_mem memory[] = {race.d_nodes, race.d_sphere_ids};
    cl_memory_release(memory, sizeof memory / sizeof *memory);
    scene_buffers_free(&race.buffers);
    tile_buffers_free(&race.tiles);
    scene3d_free(&race.scene);
    probe_close(&race.probe);
    return EXIT_SUCCESS;
}
