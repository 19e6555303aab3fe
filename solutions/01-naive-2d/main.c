// Lab 01: draw circles the naive way and save the picture. Nothing to fill in here; read it from
// top to bottom once, then go to overlaps_N_Nearer.cl and implicit2DRenderer.cl.
//
// Flow: scene -> buffers -> kernel -> image -> comparison; the banners below name the steps.
// enqueue_pixels() and read_back() are those of lab 00 (render.h).
#include "circle.h"
#include "cl_memory.h"
#include "cl_setup.h"
#include "frames.h"
#include "image.h"
#include "options.h"
#include "render.h"
#include "scene2d.h"
#include "stats.h"
#include "work_stats.h"

#include <stdlib.h>

// What the kernel reads and writes on the device.
typedef struct DeviceMemory {
    cl_mem d_circles;
    cl_mem d_image;
    cl_mem d_work;  // counters, or NULL when nothing is counted
} DeviceMemory;

static void device_memory_free(DeviceMemory *memory)
{
    cl_mem objects[] = {memory->d_circles, memory->d_image, memory->d_work};
    for (size_t i = 0; i < sizeof objects / sizeof *objects; i++) {
        if (objects[i] != NULL) {
            CL_CHECK(clReleaseMemObject(objects[i]));
        }
    }
}

// The arguments, in the order of the kernel's parameter list.
static void set_kernel_arguments(cl_kernel kernel, const Scene2D *scene, const DeviceMemory *memory)
{
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof memory->d_circles, &memory->d_circles));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->n_circles, &scene->n_circles));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof memory->d_image, &memory->d_image));
    if (memory->d_work != NULL) {
        CL_CHECK(clSetKernelArg(kernel, 5, sizeof memory->d_work, &memory->d_work));
    }
}

// Build the program and draw n_frames with it. Returns 0, or -1 after one message.
static int draw(const ClSetup *cl, const Scene2D *scene, const DeviceMemory *memory,
                const char *build_options, int n_frames, Stats *stats)
{
    // ---- Program ---------------------------------------------------------------------------
    cl_program program = cl_setup_build(cl, LAB_FOLDER "/implicit2DRenderer.cl", build_options);
    if (program == NULL) {
        return -1;
    }

    // ---- Kernel ----------------------------------------------------------------------------
    cl_int error;
    cl_kernel kernel = clCreateKernel(program, "implicit2DRenderer", &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    set_kernel_arguments(kernel, scene, memory);
    frames_draw(cl, enqueue_pixels, kernel, scene->width, scene->height, n_frames, stats);

    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    return 0;
}

// From the open device to the picture in the host's memory. Returns 0, or -1 after one message.
static int render(const ClSetup *cl, const Options *options, const Scene2D *scene, Image *image,
                  Stats *stats)
{
    // ---- Buffers ---------------------------------------------------------------------------
    DeviceMemory memory = {0};
    memory.d_image = cl_image_create(cl, scene->width, scene->height);
    if (memory.d_image == NULL) {
        return -1;
    }
    // OpenCL knows no empty buffer: a scene without circles hands the kernel NULL.
    if (scene->n_circles > 0) {
        cl_int error;
        memory.d_circles = clCreateBuffer(cl->context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                                          (size_t)scene->n_circles * sizeof *scene->circles,
                                          scene->circles, &error);
        CL_CHECK_CREATED(error, clCreateBuffer);
    }

    int result = draw(cl, scene, &memory, KERNEL_OPTIONS, options->n_frames, stats);
    if (result == 0 && (options->stats != NULL || options->heat_map)) {
        // Counting slows a kernel down, so it gets a frame of its own.
        Stats counting_times = {0};
        memory.d_work = work_buffer_create(cl, scene->width, scene->height);
        result = draw(cl, scene, &memory, KERNEL_OPTIONS " -DCOUNT_WORK", 1, &counting_times);
        if (result == 0) {
            result = work_report(cl, memory.d_work, scene->width, scene->height, WORK_CIRCLES,
                                 options->heat_map ? options->output : NULL, stats);
        }
        stats_free(&counting_times);
    }

    // ---- Image -----------------------------------------------------------------------------
    if (result == 0) {
        read_back(cl->queue, memory.d_image, scene->width, scene->height, image->pixels);
    }
    device_memory_free(&memory);
    return result;
}

int main(int argc, char **argv)
{
    // ---- Options ---------------------------------------------------------------------------
    Options options;
    switch (options_parse(argc, argv, LAB_NAME, "Draws circles; every pixel asks every circle.",
                          OPTIONS_SCENE | OPTIONS_DEVICE | OPTIONS_WORK, &options)) {
    case OPTIONS_BAD:
        return EXIT_FAILURE;
    case OPTIONS_DONE:
        return EXIT_SUCCESS;
    case OPTIONS_RUN:
        break;
    }

    // ---- Scene, device ---------------------------------------------------------------------
    ClSetup cl = {0};
    Scene2D scene = {0};
    Image image = {0};
    Stats stats = {0};
    int result = scene2d_open(options.scene, options.width, options.height, &scene);
    if (result == 0) {
        result = cl_setup_open(options.device, &cl);
    }
    if (result == 0) {
        stats_text(&stats, "lab", LAB_NAME);
        stats_text(&stats, "device", cl.device_name);
        stats_text(&stats, "scene", options.scene);
        stats_integer(&stats, "n_circles", scene.n_circles);
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
    scene2d_free(&scene);
    cl_setup_close(&cl);
    return result == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
