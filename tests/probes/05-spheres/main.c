// Probe of lab 05: each of the student's functions on the job's inputs, then whole scenes: what
// each ray hits, the picture, and the work of each pixel ("work.K").
#include "probe.h"

#include "jobs_05.h"
#include "work.h"

#include <stdlib.h>

static void answer_functions(const Probe *probe, cl_program program)
{
    static const char *const lights = "lights";
    probe_call(probe, program, "roots", sizeof(RootJob), sizeof(cl_float), NULL, 0);
    probe_call(probe, program, "textbook", sizeof(SphereRayJob), sizeof(cl_float), NULL, 0);
    probe_call(probe, program, "projection", sizeof(SphereRayJob), sizeof(cl_float), NULL, 0);
    probe_call(probe, program, "normals", sizeof(NormalJob), sizeof(Vec3), NULL, 0);
    probe_call_with(probe, program, "shades", sizeof(ShadeJob), sizeof(Vec3), &lights, 1);
    probe_call_with(probe, program, "pixel_shades", sizeof(ShadeJob), sizeof(Vec3), &lights, 1);
}

static void answer_hits(const Probe *probe, int k, const SceneJob3D *scene,
                        const Scene3DBuffers *buffers, cl_kernel kernel)
{
    const size_t n_bytes = (size_t)scene->width * (size_t)scene->height * sizeof(HitAnswer);
    cl_mem d_hits = probe_buffer(probe, n_bytes);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof(cl_mem), &buffers->d_arrays[0]));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->n_spheres, &scene->n_spheres));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->camera, &scene->camera));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof d_hits, &d_hits));
    probe_note(probe, "hits", (uint32_t)k);
    probe_launch(probe, kernel, scene->width, scene->height);
    probe_answer_buffer(probe, "hits", k, d_hits, n_bytes);
}

static void answer_picture(const Probe *probe, int k, const SceneJob3D *scene,
                           const Scene3DBuffers *buffers, cl_kernel kernel)
{
    probe_scene3d_set(buffers, scene, kernel);
    CL_CHECK(
        clSetKernelArg(kernel, N_SCENE3D_ARGUMENTS, sizeof scene->n_spheres, &scene->n_spheres));
    probe_draw_counting(probe, k, kernel, buffers->d_image, scene->width, scene->height,
                        N_SCENE3D_ARGUMENTS + 1);
}

static void answer_scenes(const Probe *probe, cl_program program, cl_kernel kernel)
{
    cl_kernel hits_kernel = probe_kernel(program, "probe_hits");
    const SceneJob3D *scene;
    for (int k = 0; (scene = probe_scene3d(probe, k)) != NULL; k++) {
        Scene3DBuffers buffers = probe_scene3d_buffers(probe, k, scene);
        answer_hits(probe, k, scene, &buffers, hits_kernel);
        answer_picture(probe, k, scene, &buffers, kernel);
        probe_scene3d_release(&buffers);
    }
    CL_CHECK(clReleaseKernel(hits_kernel));
}

// nearest_hit alone: what the rays of a scene of squares hit, and their work.
static void answer_squares(const Probe *probe, int k, const SceneJob3D *scene, cl_kernel kernel)
{
    const size_t n_pixels = (size_t)scene->width * (size_t)scene->height;
    cl_mem d_squares = probe_part_create(probe, k, "spheres");
    cl_mem d_hits = probe_buffer(probe, n_pixels * sizeof(HitAnswer));
    cl_mem d_work = probe_buffer(probe, n_pixels * sizeof(Work));
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_squares, &d_squares));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->n_spheres, &scene->n_spheres));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof d_hits, &d_hits));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof d_work, &d_work));
    probe_note(probe, "hits", (uint32_t)k);
    probe_launch(probe, kernel, scene->width, scene->height);
    probe_answer_buffer(probe, "hits", k, d_hits, n_pixels * sizeof(HitAnswer));
    probe_answer_buffer(probe, "work", k, d_work, n_pixels * sizeof(Work));
    CL_CHECK(clReleaseMemObject(d_squares));
}

static void answer_all_squares(const Probe *probe, cl_program program)
{
    cl_kernel kernel = probe_kernel(program, "probe_squares");
    const SceneJob3D *scene;
    for (int k = 0; (scene = probe_scene3d(probe, k)) != NULL; k++) {
        answer_squares(probe, k, scene, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
}

int main(void)
{
    Probe probe;
    cl_program program = probe_open_program(&probe, PROBE_PROGRAM, PROBE_COUNTING);
    cl_kernel kernel = probe_kernel(program, "render_spheres");
    answer_functions(&probe, program);
    if (probe_alone(&probe, "nearest_hit")) {
        answer_all_squares(&probe, program);
    } else {
        answer_scenes(&probe, program, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    probe_close_program(&probe, program);
    return EXIT_SUCCESS;
}
