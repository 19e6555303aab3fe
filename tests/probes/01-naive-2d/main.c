// Probe of lab 01: overlaps_N_Nearer on the job's inputs, then the student's kernel on its scenes.
#include "jobs_01.h"
#include "probe.h"

#include <stdlib.h>

static void answer_picture(const Probe *probe, int k, const SceneJob *scene, cl_kernel kernel)
{
    cl_mem d_circles = probe_part_create(probe, k, "circles");
    cl_mem d_image = probe_image(probe, scene->width, scene->height);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_circles, &d_circles));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->n_circles, &scene->n_circles));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_image, &d_image));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof(cl_mem), NULL));  // nothing is counted
    if (probe_alone(probe, "implicit2DRenderer")) {
        probe_draw_rows(probe, k, kernel, d_image, scene->width, scene->height);
    } else {
        probe_draw(probe, k, kernel, d_image, scene->width, scene->height);
    }
    CL_CHECK(clReleaseMemObject(d_circles));
    CL_CHECK(clReleaseMemObject(d_image));
}

int main(void)
{
    Probe probe;
    cl_program program =
        probe_open_program(&probe, PROBE_PROGRAM, "-I " LAB_FOLDER " -I kernels -I probes");
    cl_kernel kernel = probe_kernel(program, "implicit2DRenderer");
    probe_call(&probe, program, "overlaps", sizeof(OverlapJob), sizeof(cl_int), NULL, 0);
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_picture(&probe, k, scene, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    probe_close_program(&probe, program);
    return EXIT_SUCCESS;
}
