// Lab 00: draw a gradient and save it. Nothing to fill in here; read it from top to bottom once,
// then go to render.c (host) and gradient.cl (device).
//
// Flow: [no scene] -> buffers -> kernel -> image -> comparison; the banners below name the steps.
#include "render.h"

#include "cl_memory.h"
#include "cl_setup.h"
#include "frames.h"
#include "image.h"
#include "options.h"
#include "stats.h"

#include <stdlib.h>

// From the open device to the picture in the host's memory. Returns 0, or -1 after one message.
static int render(const ClSetup *cl, const Options *options, Image *image, Stats *stats)
{
    if (cl_image_check_size(cl, image->width, image->height) != 0) {
        return -1;
    }

    // ---- Program ---------------------------------------------------------------------------
    cl_program program = cl_setup_build(cl, LAB_FOLDER "/gradient.cl", KERNEL_OPTIONS);
    if (program == NULL) {
        return -1;
    }

    // ---- Buffers ---------------------------------------------------------------------------
    const cl_image_format format = {CL_RGBA, CL_FLOAT};
    const cl_image_desc desc = {.image_type = CL_MEM_OBJECT_IMAGE2D,
                                .image_width = (size_t)image->width,
                                .image_height = (size_t)image->height};
    // New memory holds whatever was there, so the image begins as a copy of the host's, which is
    // black: so is a pixel that no work-item writes.
    cl_int error;
    cl_mem d_image = clCreateImage(cl->context, CL_MEM_WRITE_ONLY | CL_MEM_COPY_HOST_PTR, &format,
                                   &desc, image->pixels, &error);
    CL_CHECK_CREATED(error, clCreateImage);

    // ---- Kernel ----------------------------------------------------------------------------
    cl_kernel kernel = clCreateKernel(program, "gradient", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    set_arguments(kernel, image->width, image->height, d_image);
    frames_draw(cl, enqueue_pixels, kernel, image->width, image->height, options->n_frames, stats);

    // ---- Image -----------------------------------------------------------------------------
    read_back(cl->queue, d_image, image->width, image->height, image->pixels);

    CL_CHECK(clReleaseMemObject(d_image));
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    return 0;
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Options options;
    switch (
        options_parse(argc, argv, LAB_NAME, "Draws a colour gradient.", OPTIONS_DEVICE, &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }

    // ---- Device ----------------------------------------------------------------------------
    ClSetup cl = {0};
    Image image = {0};
    Stats stats = {0};
    const int width = options.width ? options.width : 640;
    const int height = options.height ? options.height : 480;
    int result = cl_setup_open(options.device, &cl);
    if (result == 0) {
        stats_text(&stats, "lab", LAB_NAME);
        stats_text(&stats, "device", cl.device_name);
        stats_integer(&stats, "width", width);
        stats_integer(&stats, "height", height);
        result = image_create(width, height, &image);
    }

    // ---- Buffers, kernel, image ------------------------------------------------------------
    if (result == 0) {
        result = render(&cl, &options, &image, &stats);
    }
    if (result == 0) {
        result = image_save(&image, options.output);
    }
    if (result == 0) {
        result = stats_report(&stats, options.stats);
    }
    stats_free(&stats);
    image_free(&image);
    cl_setup_close(&cl);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
