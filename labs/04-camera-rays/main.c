// Lab 04: make a ray for every pixel and draw its direction. Nothing to fill in here; read it from
// top to bottom once, then go to camera_from_view.c and primary_ray.cl.
//
// Flow: scene (only its view) -> buffers -> kernel -> image -> comparison; the banners below name
// the steps. enqueue_pixels() and read_back() are those of lab 00 (render.h).
#include "camera_from_view.h"
#include "cl_memory.h"
#include "cl_setup.h"
#include "frames.h"
#include "image.h"
#include "options.h"
#include "render.h"
#include "scene3d.h"
#include "stats.h"

#include <stdlib.h>

// From the open device to the picture in the host's memory. Returns 0, or -1 after one message.
static int render(const ClSetup *cl, const Options *options, const Scene3D *scene, Image *image,
                  Stats *stats)
{
    // ---- Buffers ---------------------------------------------------------------------------
    cl_mem d_image = cl_image_create(cl, scene->width, scene->height);
    if (d_image == NULL) {
        return -1;
    }
    const Camera camera = camera_from_view(scene->view, scene->width, scene->height);

    // ---- Program ---------------------------------------------------------------------------
    cl_program program = cl_setup_build(cl, LAB_FOLDER "/draw_directions.cl", KERNEL_OPTIONS);
    if (program == NULL) {
        CL_CHECK(clReleaseMemObject(d_image));
        return -1;
    }

    // ---- Kernel ----------------------------------------------------------------------------
    cl_int error;
    cl_kernel kernel = clCreateKernel(program, "draw_directions", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof camera, &camera));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof d_image, &d_image));
    frames_draw(cl, enqueue_pixels, kernel, scene->width, scene->height, options->n_frames, stats);

    // ---- Image -----------------------------------------------------------------------------
    read_back(cl->queue, d_image, scene->width, scene->height, image->pixels);

    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    CL_CHECK(clReleaseMemObject(d_image));
    return 0;
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Options options;
    switch (options_parse(argc, argv, LAB_NAME, "Draws the directions of the rays as colours.",
                          OPTIONS_SCENE3D | OPTIONS_DEVICE, &options)) {
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
        stats_integer(&stats, "width", scene.width);
        stats_integer(&stats, "height", scene.height);
        stats_number(&stats, "fov", scene3d_fov(&scene.view, scene.width, scene.height));
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
