// Probe of lab 00: the student's three host functions and kernel on several sizes.
//
// Each size gives "picture.K", the image as the kernel left it, and "readback.K", what read_back()
// brought home into an array of NaNs; and "items.K", how many work-items enqueue_pixels() starts
// for each place of that image, and one number behind them: how many stand outside of it.
#include "probe.h"
#include "render.h"

#include "cl_memory.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

// Hold the queue up until `release` is set, which a thread of its own does a little later: a read
// that does not wait then comes back before the picture does.
static void *release_later(void *release)
{
    const struct timespec delay = {0, 50 * 1000 * 1000};
    nanosleep(&delay, NULL);
    CL_CHECK(clSetUserEventStatus(release, CL_COMPLETE));
    return NULL;
}

// Call read_back() behind a queue that is held up.
static void read_back_late(const Probe *probe, cl_mem d_image, const SceneJob *scene,
                           float *h_pixels)
{
    cl_int error;
    pthread_t thread;
    cl_event release = clCreateUserEvent(probe->cl.context, &error);
    CL_CHECK_CREATED(error, clCreateUserEvent);
    CL_CHECK(clEnqueueBarrierWithWaitList(probe->cl.queue, 1, &release, NULL));
    if (pthread_create(&thread, NULL, release_later, release) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    read_back(probe->cl.queue, d_image, scene->width, scene->height, h_pixels);
}

static void answer_read_back(const Probe *probe, int k, cl_mem d_image, const SceneJob *scene)
{
    const size_t n_floats = (size_t)scene->width * (size_t)scene->height * 4;
    float *h_pixels = malloc(n_floats * sizeof *h_pixels);
    for (size_t i = 0; i < n_floats; i++) {
        h_pixels[i] = NAN;
    }
    probe_note(probe, "readback", (uint32_t)k);
    if (k == 0) {
        read_back_late(probe, d_image, scene, h_pixels);
    } else {
        read_back(probe->cl.queue, d_image, scene->width, scene->height, h_pixels);
    }
    // As it is when read_back() returns: what arrives later is too late.
    probe_answer(probe, "readback", k, NULL, h_pixels, n_floats * sizeof *h_pixels);
    CL_CHECK(clFinish(probe->cl.queue));
    free(h_pixels);
}

static void answer_items(const Probe *probe, int k, cl_program program, const SceneJob *scene)
{
    const size_t n_places =
        (size_t)PROBE_IMAGE_SIDE(scene->width) * (size_t)PROBE_IMAGE_SIDE(scene->height);
    const size_t n_bytes = (n_places + 1) * sizeof(cl_uint);
    void *zeros = calloc(1, n_bytes);
    if (zeros == NULL) {
        exit(PROBE_EXIT_FAULT);
    }
    cl_int error;
    cl_mem d_counts = clCreateBuffer(probe->cl.context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                                     n_bytes, zeros, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    cl_kernel kernel = probe_kernel(program, "count_items");
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof d_counts, &d_counts));
    probe_note(probe, "items", (uint32_t)k);
    enqueue_pixels(probe->cl.queue, kernel, scene->width, scene->height);
    probe_answer_buffer(probe, "items", k, d_counts, n_bytes);
    CL_CHECK(clReleaseKernel(kernel));
    free(zeros);
}

// Call set_arguments() for a kernel of ours and launch that one. OpenCL may take a handle that is
// none, and notice only at the launch: then this is where it ends, and not in enqueue_pixels().
static void try_arguments(const Probe *probe, int k, cl_program program, const SceneJob *scene)
{
    const size_t one = 1;
    cl_kernel kernel = probe_kernel(program, "take_arguments");
    cl_mem d_image = probe_image(probe, scene->width, scene->height);
    probe_note(probe, "arguments", (uint32_t)k);
    set_arguments(kernel, scene->width, scene->height, d_image);
    cl_int error =
        clEnqueueNDRangeKernel(probe->cl.queue, kernel, 1, NULL, &one, NULL, 0, NULL, NULL);
    error = error == CL_SUCCESS ? clFinish(probe->cl.queue) : error;
    if (error != CL_SUCCESS) {
        fprintf(stderr, "launching a kernel with these arguments: %s (%d)\n", cl_error_name(error),
                error);
        exit(EXIT_FAILURE);
    }
    CL_CHECK(clReleaseMemObject(d_image));
    CL_CHECK(clReleaseKernel(kernel));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    probe_open_device(&probe);
    cl_program program = probe_build(&probe, LAB_FOLDER "/gradient.cl", "-I kernels");
    cl_program counting =
        probe_build(&probe, "probes/probe_" LAB_NAME ".cl", "-I kernels -I probes");
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        try_arguments(&probe, k, counting, scene);
        cl_kernel kernel = probe_kernel(program, "gradient");
        cl_mem d_image = probe_image(&probe, scene->width, scene->height);
        set_arguments(kernel, scene->width, scene->height, d_image);
        probe_note(&probe, "picture", (uint32_t)k);
        enqueue_pixels(probe.cl.queue, kernel, scene->width, scene->height);
        CL_CHECK(clFinish(probe.cl.queue));
        probe_answer_image(&probe, k, d_image, scene->width, scene->height);
        answer_read_back(&probe, k, d_image, scene);
        answer_items(&probe, k, counting, scene);
        CL_CHECK(clReleaseMemObject(d_image));
        CL_CHECK(clReleaseKernel(kernel));
    }
    CL_CHECK(clReleaseProgram(counting));
    CL_CHECK(clReleaseProgram(program));
    probe_close(&probe);
    return EXIT_SUCCESS;
}
