// Lab 05: trace spheres the naive way and save the picture. Nothing to fill in here; read it from
// top to bottom once, then go to intersect_sphere.cl, nearest_hit.cl and shade.cl.
//
// Flow: scene -> buffers -> kernel -> image -> comparison; the banners below name the steps.
// enqueue_pixels() and read_back() are those of lab 00 (render.h).
#include "cl_setup.h"
#include "frames.h"
#include "image.h"
#include "options.h"
#include "render.h"
#include "scene3d.h"
#include "scene_buffers.h"
#include "stats.h"
#include "work_stats.h"

#include <stdlib.h>

// Build the program and draw n_frames with it.
//   d_work   counters, or NULL when nothing is counted
// Returns 0, or -1 after one message.
static int draw(const ClSetup *cl, const Scene3D *scene, const SceneBuffers *buffers,
                const char *build_options, cl_mem d_work, int n_frames, Stats *stats)
{
    // ---- Program ---------------------------------------------------------------------------
    cl_program program = cl_setup_build(cl, LAB_FOLDER "/render_spheres.cl", build_options);
    if (program == NULL) {
        return -1;
    }

    // ---- Kernel ----------------------------------------------------------------------------
    cl_int error;
    cl_kernel kernel = clCreateKernel(program, "render_spheres", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    scene_buffers_set(buffers, scene, kernel);
    CL_CHECK(clSetKernelArg(kernel, N_SCENE_ARGUMENTS, sizeof scene->n_spheres, &scene->n_spheres));
    if (d_work != NULL) {
        CL_CHECK(clSetKernelArg(kernel, N_SCENE_ARGUMENTS + 1, sizeof d_work, &d_work));
    }
    frames_draw(cl, enqueue_pixels, kernel, scene->width, scene->height, n_frames, stats);

    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    return 0;
}

// Draw with a kernel that counts the work of each pixel. Returns 0, or -1 after one message.
static int count_work(const ClSetup *cl, const Options *options, const Scene3D *scene,
                      const SceneBuffers *buffers, Stats *stats)
{
    // Counting slows a kernel down: its time is not among the figures.
    Stats counting_times = {0};
    cl_mem d_work = work_buffer_create(cl, scene->width, scene->height);
    int result =
        draw(cl, scene, buffers, KERNEL_OPTIONS " -DCOUNT_WORK", d_work, 1, &counting_times);
    if (result == 0) {
        result = work_report(cl, d_work, scene->width, scene->height, WORK_SPHERES,
                             options->heat_map ? options->output : NULL, stats);
    }
    stats_free(&counting_times);
    CL_CHECK(clReleaseMemObject(d_work));
    return result;
}

// From the open device to the picture in the host's memory. Returns 0, or -1 after one message.
static int render(const ClSetup *cl, const Options *options, const Scene3D *scene, Image *image,
                  Stats *stats)
{
    // ---- Buffers ---------------------------------------------------------------------------
    SceneBuffers buffers;
    if (scene_buffers_create(cl, scene, &buffers) != 0) {
        return -1;
    }

    int result = 0;
    if (options->stats != NULL || options->heat_map) {
        result = count_work(cl, options, scene, &buffers, stats);
    }
    if (result == 0) {
        result = draw(cl, scene, &buffers,
                      options->textbook ? KERNEL_OPTIONS " -DTEXTBOOK" : KERNEL_OPTIONS, NULL,
                      options->n_frames, stats);
    }

    // ---- Image -----------------------------------------------------------------------------
    if (result == 0) {
        read_back(cl->queue, buffers.d_image, scene->width, scene->height, image->pixels);
    }
    scene_buffers_free(&buffers);
    return result;
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Options options;
    switch (options_parse(argc, argv, LAB_NAME, "Traces spheres; every ray asks every sphere.",
                          OPTIONS_SCENE3D | OPTIONS_DEVICE | OPTIONS_WORK | OPTIONS_TEXTBOOK,
                          &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }

    // ---- Scene, device ---------------------------------------------------------------------
    ClSetup cl = {0};
    Scene3D scene = {0};
    Image image = {0};
    Stats stats = {0};
    int result = scene3d_open(options.scene, options.width, options.height, &scene);
    if (result == 0) {
        result = cl_setup_open(options.device, &cl);
    }
    if (result == 0) {
        stats_text(&stats, "lab", LAB_NAME);
        stats_text(&stats, "device", cl.device_name);
        stats_text(&stats, "scene", options.scene);
        stats_integer(&stats, "n_spheres", scene.n_spheres);
        stats_integer(&stats, "width", scene.width);
        stats_integer(&stats, "height", scene.height);
        result = image_create(scene.width, scene.height, &image);
    }

    // ---- Buffers, kernel, image ------------------------------------------------------------
    if (result == 0) {
        result = render(&cl, &options, &scene, &image, &stats);
    }
    if (result == 0) {
        result = image_save(&image, options.output);
    }
    if (result == 0) {
        result = stats_report(&stats, options.stats);
    }
    stats_free(&stats);
    image_free(&image);
    scene3d_free(&scene);
    cl_setup_close(&cl);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
