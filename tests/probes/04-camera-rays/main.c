// Probe of lab 04: camera_axes on the host, pixel_on_display and primary_ray on the device, each on
// the job's inputs; then the student's kernel with given cameras.
#include "camera_from_view.h"
#include "jobs_04.h"
#include "probe.h"

#include <stdlib.h>

static void answer_axes(const Probe *probe)
{
    size_t n_bytes;
    const ViewJob *jobs = probe_job(probe, "views", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    const Vec3 unwritten = {UNWRITTEN, UNWRITTEN, UNWRITTEN};
    Vec3(*axes)[3] = calloc(n, sizeof *axes);
    for (size_t i = 0; i < n; i++) {
        const View view = {
            .from = jobs[i].from, .at = jobs[i].at, .up = jobs[i].up, .angle = 45, .hither = 1};
        probe_note(probe, "views", (uint32_t)i);
        axes[i][0] = axes[i][1] = axes[i][2] = unwritten;
        camera_axes(view, &axes[i][0], &axes[i][1], &axes[i][2]);
    }
    probe_answer(probe, "axes", -1, NULL, axes, n * sizeof *axes);
    free(axes);
}

static void answer_picture(const Probe *probe, int k, const SceneJob3D *scene, cl_kernel kernel)
{
    cl_mem d_image = probe_image(probe, scene->width, scene->height);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof scene->camera, &scene->camera));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof d_image, &d_image));
    probe_draw(probe, k, kernel, d_image, scene->width, scene->height);
    CL_CHECK(clReleaseMemObject(d_image));
}

static cl_program kernels_build(Probe *probe)
{
    probe_open_device(probe);
    return probe_build(probe, PROBE_PROGRAM, PROBE_KERNEL_OPTIONS " -I " LAB_FOLDER " -I probes");
}

static void answer_kernels(const Probe *probe, cl_program program)
{
    cl_kernel kernel = probe_kernel(program, "draw_directions");
    probe_call(probe, program, "pixels", sizeof(PixelJob), sizeof(PixelAnswer), NULL, 0);
    const SceneJob3D *scene;
    for (int k = 0; (scene = probe_scene3d(probe, k)) != NULL; k++) {
        answer_picture(probe, k, scene, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    // First of all: that kernels do not compile is believed of who has called no answer yet.
    cl_program program = probe_alone(&probe, "camera_axes") ? NULL : kernels_build(&probe);
    if (probe_asks(&probe, "views")) {
        answer_axes(&probe);
    }
    if (program != NULL) {
        answer_kernels(&probe, program);
    }
    probe_close(&probe);
    return EXIT_SUCCESS;
}
