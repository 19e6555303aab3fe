// Probe of lab 00: the student's kernel and three host functions on several sizes.
//
// Nothing that is tried needs another task. The kernel comes first, launched by the probe itself,
// before any function of the student's: "picture.K". set_arguments() is called for a kernel of the
// probe that tells what arrived, "arguments.K"; enqueue_pixels() launches one that counts its
// work-items, "items.K"; read_back() copies an image that the probe fills, "readback.K",
// from a queue that is held up (held_queue.h).
#include "held_queue.h"
#include "pattern.h"
#include "probe.h"
#include "render.h"

#include "cl_memory.h"
#include "jobs_00.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// An image as large as the picture, without a margin, as the lab's own.
static cl_mem exact_image(const Probe *probe, const SceneJob *scene)
{
    cl_mem d_image;
    if (cl_image_create(&probe->cl, scene->width, scene->height, &d_image) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    return d_image;
}

// ---- gradient -----------------------------------------------------------------------------------

static void answer_picture(const Probe *probe, int k, const SceneJob *scene, cl_program program)
{
    cl_kernel kernel = probe_kernel(program, "gradient");
    cl_mem d_image = probe_image(probe, scene->width, scene->height);
    const struct {
        size_t n_bytes;
        const void *value;
    } arguments[] = {{sizeof scene->width, &scene->width},
                     {sizeof scene->height, &scene->height},
                     {sizeof(cl_mem), &d_image}};
    for (cl_uint i = 0; i < sizeof arguments / sizeof *arguments; i++) {
        CL_CHECK(clSetKernelArg(kernel, i, arguments[i].n_bytes, arguments[i].value));
    }
    probe_draw(probe, k, kernel, d_image, scene->width, scene->height);
    CL_CHECK(clReleaseMemObject(d_image));
    CL_CHECK(clReleaseKernel(kernel));
}

static void answer_pictures(const Probe *probe)
{
    cl_program program = probe_build(probe, "probes/" LAB_NAME "/picture.cl",
                                     "-I " LAB_FOLDER " -I kernels -I probes");
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(probe, k)) != NULL; k++) {
        answer_picture(probe, k, scene, program);
    }
    CL_CHECK(clReleaseProgram(program));
}

// ---- set_arguments ------------------------------------------------------------------------------

// What a kernel writes into the first pixel. The image is wiped after set_arguments() has had it.
static ArgumentsAnswer launch_with_arguments(const Probe *probe, cl_kernel kernel, cl_mem d_image)
{
    const cl_float4 color = {{UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN}};
    const size_t corner[3] = {0, 0, 0}, pixel[3] = {1, 1, 1}, one = 1;
    cl_command_queue queue = probe->cl.queue;
    ArgumentsAnswer answer;
    CL_CHECK(clEnqueueFillImage(queue, d_image, &color, corner, pixel, 0, NULL, NULL));
    answer.error = clEnqueueNDRangeKernel(queue, kernel, 1, NULL, &one, NULL, 0, NULL, NULL);
    answer.error = answer.error == CL_SUCCESS ? clFinish(queue) : answer.error;
    size_t n_row_bytes;
    const void *mapped = probe_map_image(probe, d_image, pixel, &n_row_bytes);
    memcpy(answer.arrived, mapped, sizeof answer.arrived);
    probe_unmap_image(probe, d_image, mapped);
    return answer;
}

static void answer_arguments(const Probe *probe, int k, const SceneJob *scene, cl_program program)
{
    cl_kernel kernel = probe_kernel(program, "take_arguments");
    cl_mem d_image = exact_image(probe, scene);
    probe_note(probe, "arguments", (uint32_t)k);
    set_arguments(kernel, scene->width, scene->height, d_image);
    const ArgumentsAnswer answer = launch_with_arguments(probe, kernel, d_image);
    probe_answer(probe, "arguments", k, NULL, &answer, sizeof answer);
    CL_CHECK(clReleaseMemObject(d_image));
    CL_CHECK(clReleaseKernel(kernel));
}

// ---- enqueue_pixels -----------------------------------------------------------------------------

static void answer_items(const Probe *probe, int k, const SceneJob *scene, cl_program program)
{
    const size_t n_places =
        (size_t)PROBE_IMAGE_SIDE(scene->width) * (size_t)PROBE_IMAGE_SIDE(scene->height);
    const size_t n_bytes = (n_places + N_ITEMS_REST) * sizeof(cl_uint);
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

// ---- read_back ----------------------------------------------------------------------------------

static void answer_read_back(const Probe *probe, int k, const SceneJob *scene)
{
    const size_t corner[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)scene->width, (size_t)scene->height, 1};
    const size_t n_floats = region[0] * region[1] * 4;
    size_t n_bytes;
    const u32 *key = probe_scene_part(probe, k, "pattern", &n_bytes);
    float *h_pattern = malloc(n_floats * sizeof *h_pattern);
    const size_t n_written = n_floats + READ_BACK_GUARD, n_answers = n_floats + N_READ_BACK_REST;
    float *h_pixels = malloc(n_written * sizeof *h_pixels);
    float *answers = calloc(n_answers, sizeof *answers);
    if (h_pattern == NULL || h_pixels == NULL || answers == NULL || n_bytes != sizeof *key) {
        exit(PROBE_EXIT_FAULT);
    }
    for (size_t i = 0; i < n_floats; i++) {
        h_pattern[i] = pattern_value(*key, (u32)i);
    }
    for (size_t i = 0; i < n_written; i++) {
        h_pixels[i] = i < n_floats ? NAN : UNWRITTEN;
    }
    cl_mem d_image = exact_image(probe, scene);
    queue_hold(probe->cl.queue);
    CL_CHECK(clEnqueueWriteImage(probe->cl.queue, d_image, CL_FALSE, corner, region, 0, 0,
                                 h_pattern, 0, NULL, NULL));
    probe_note(probe, "readback", (uint32_t)k);
    read_back(probe->cl.queue, d_image, scene->width, scene->height, h_pixels);
    // As it is when read_back() returns: what arrives later is too late.
    memcpy(answers, h_pixels, n_written * sizeof *answers);
    queue_release();
    CL_CHECK(clFinish(probe->cl.queue));
    answers[n_floats + READ_BACK_LATE] =
        memcmp(answers, h_pixels, n_written * sizeof *answers) != 0;
    probe_answer(probe, "readback", k, NULL, answers, n_answers * sizeof *answers);
    CL_CHECK(clReleaseMemObject(d_image));
    free(h_pattern);
    free(answers);
    free(h_pixels);
}

// ---- All of it ----------------------------------------------------------------------------------

// With a whole submission every task is tried, with one task's answer that task.
static int is_tried(const Probe *probe, const char *task)
{
    return !probe_asks(probe, PROBE_ALONE) || probe_alone(probe, task);
}

static void answer_host(const Probe *probe)
{
    cl_program program = probe_build(probe, "probes/" LAB_NAME "/probe.cl", "-I kernels -I probes");
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(probe, k)) && is_tried(probe, "set_arguments"); k++) {
        answer_arguments(probe, k, scene, program);
    }
    for (int k = 0; (scene = probe_scene(probe, k)) && is_tried(probe, "enqueue_pixels"); k++) {
        answer_items(probe, k, scene, program);
    }
    for (int k = 0; (scene = probe_scene(probe, k)) && is_tried(probe, "read_back"); k++) {
        answer_read_back(probe, k, scene);
    }
    CL_CHECK(clReleaseProgram(program));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    probe_open_device(&probe);
    if (is_tried(&probe, "gradient")) {
        answer_pictures(&probe);
    }
    if (getenv(PROBE_KERNELS_VARIABLE) == NULL && !probe_alone(&probe, "gradient")) {
        answer_host(&probe);
    }
    probe_close(&probe);
    return EXIT_SUCCESS;
}
