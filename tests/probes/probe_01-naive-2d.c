// Probe of lab 01: overlaps_N_Nearer on the job's inputs, then the student's kernel on its scenes.
#include "probe.h"

#include "cl_memory.h"

#include <stdlib.h>

static void answer_overlaps(const Probe *probe, cl_program program)
{
    size_t n_bytes;
    const OverlapJob *jobs = probe_job(probe, "overlaps", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    cl_kernel kernel = probe_kernel(program, "probe_overlaps");
    cl_int *answers = calloc(n, sizeof *answers);
    cl_mem d_jobs = cl_buffer_create(&probe->cl, jobs, n_bytes);
    cl_int error;
    cl_mem d_answers =
        clCreateBuffer(probe->cl.context, CL_MEM_WRITE_ONLY, n * sizeof *answers, NULL, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_jobs, &d_jobs));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof d_answers, &d_answers));
    CL_CHECK(clEnqueueNDRangeKernel(probe->cl.queue, kernel, 1, NULL, &n, NULL, 0, NULL, NULL));
    CL_CHECK(clEnqueueReadBuffer(probe->cl.queue, d_answers, CL_TRUE, 0, n * sizeof *answers,
                                 answers, 0, NULL, NULL));
    if (section_write(probe->answers, "overlaps", answers, n * sizeof *answers) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    CL_CHECK(clReleaseMemObject(d_jobs));
    CL_CHECK(clReleaseMemObject(d_answers));
    CL_CHECK(clReleaseKernel(kernel));
    free(answers);
}

static void answer_picture(const Probe *probe, int k, const SceneJob *scene, cl_kernel kernel)
{
    size_t n_bytes;
    const Circle *circles = probe_scene_part(probe, k, "circles", &n_bytes);
    cl_mem d_circles = cl_buffer_create(&probe->cl, circles, n_bytes);
    cl_mem d_image = probe_image(probe, scene->width, scene->height);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_circles, &d_circles));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->n_circles, &scene->n_circles));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_image, &d_image));
    probe_draw(probe, k, kernel, d_image, scene->width, scene->height);
    CL_CHECK(clReleaseMemObject(d_circles));
    CL_CHECK(clReleaseMemObject(d_image));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    probe_open_device(&probe);
    cl_program program = probe_build(&probe, "probes/probe_" LAB_NAME ".cl",
                                     "-I " LAB_FOLDER " -I kernels -I probes");
    answer_overlaps(&probe, program);
    cl_kernel kernel = probe_kernel(program, "implicit2DRenderer");
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_picture(&probe, k, scene, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    probe_close(&probe);
    return EXIT_SUCCESS;
}
