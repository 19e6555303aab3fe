// Probe of lab 00: the student's three host functions and kernel on several sizes.
//
// Each size gives "picture.K", the image as the kernel left it, and "readback.K", what read_back()
// brought home into an array of NaNs.
#include "probe.h"
#include "render.h"

#include <math.h>
#include <stdlib.h>

static void answer_read_back(const Probe *probe, int k, cl_mem d_image, const SceneJob *scene)
{
    const size_t n_floats = (size_t)scene->width * (size_t)scene->height * 4;
    float *h_pixels = malloc(n_floats * sizeof *h_pixels);
    for (size_t i = 0; i < n_floats; i++) {
        h_pixels[i] = NAN;
    }
    read_back(probe->cl.queue, d_image, scene->width, scene->height, h_pixels);
    CL_CHECK(clFinish(probe->cl.queue));
    probe_answer(probe, "readback", k, NULL, h_pixels, n_floats * sizeof *h_pixels);
    free(h_pixels);
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    probe_open_device(&probe);
    cl_program program = probe_build(&probe, LAB_FOLDER "/gradient.cl", "-I kernels");
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        cl_kernel kernel = probe_kernel(program, "gradient");
        cl_mem d_image = probe_image(&probe, scene->width, scene->height);
        set_arguments(kernel, scene->width, scene->height, d_image);
        enqueue_pixels(probe.cl.queue, kernel, scene->width, scene->height);
        CL_CHECK(clFinish(probe.cl.queue));
        probe_answer_image(&probe, k, d_image, scene->width, scene->height);
        answer_read_back(&probe, k, d_image, scene);
        CL_CHECK(clReleaseMemObject(d_image));
        CL_CHECK(clReleaseKernel(kernel));
    }
    CL_CHECK(clReleaseProgram(program));
    probe_close(&probe);
    return EXIT_SUCCESS;
}
