// Probe of lab 07: each of the student's functions on the job's inputs, then whole scenes with
// their trees: what each ray hits, the picture, and the work of each pixel ("work.K").
#include "probe.h"

#include "cl_memory.h"
#include "jobs_07.h"

#include <stdlib.h>

static void answer_functions(const Probe *probe, cl_program program)
{
    static const char *const leaf_arrays[] = {"leaf_ids", "leaf_spheres"};
    probe_call(probe, program, "clips", sizeof(ClipJob), sizeof(ClipAnswer), NULL, 0);
    probe_call(probe, program, "sides", sizeof(SideJob), sizeof(cl_uint), NULL, 0);
    probe_call(probe, program, "planes", sizeof(PlaneJob), sizeof(PlaneAnswer), NULL, 0);
    probe_call_with(probe, program, "leaves", sizeof(SearchJob), sizeof(SearchAnswer), leaf_arrays,
                    2);
    probe_call(probe, program, "next_child", sizeof(NextChildJob), sizeof(NextChildAnswer), NULL,
               0);
    probe_call(probe, program, "next_waiting", sizeof(NextWaitingJob), sizeof(NextWaitingAnswer),
               NULL, 0);
}

// A scene with its tree on the device.
typedef struct TracedScene {
    const SceneJob3D *job;
    Scene3DBuffers buffers;
    cl_mem d_nodes;
    cl_mem d_sphere_ids;
} TracedScene;

static void answer_hits(const Probe *probe, int k, const TracedScene *scene, cl_kernel kernel)
{
    const SceneJob3D *job = scene->job;
    const size_t n_bytes = (size_t)job->width * (size_t)job->height * sizeof(HitAnswer);
    cl_mem d_hits = probe_buffer(probe, n_bytes);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof(cl_mem), &scene->buffers.d_arrays[0]));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof scene->d_nodes, &scene->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof scene->d_sphere_ids, &scene->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof job->bounds, &job->bounds));
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof job->camera, &job->camera));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof job->width, &job->width));
    CL_CHECK(clSetKernelArg(kernel, 6, sizeof job->height, &job->height));
    CL_CHECK(clSetKernelArg(kernel, 7, sizeof d_hits, &d_hits));
    probe_note(probe, "hits", (uint32_t)k);
    probe_launch(probe, kernel, job->width, job->height);
    probe_answer_buffer(probe, "hits", k, d_hits, n_bytes);
}

static void answer_picture(const Probe *probe, int k, const TracedScene *scene, cl_kernel kernel)
{
    const SceneJob3D *job = scene->job;
    cl_uint argument = N_SCENE3D_ARGUMENTS;
    probe_scene3d_set(&scene->buffers, job, kernel);
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof scene->d_nodes, &scene->d_nodes));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof scene->d_sphere_ids, &scene->d_sphere_ids));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof job->bounds, &job->bounds));
    probe_draw_counting(probe, k, kernel, scene->buffers.d_image, job->width, job->height,
                        argument);
}

int main(void)
{
    Probe probe;
    cl_program program = probe_open_program(&probe, PROBE_PROGRAM, PROBE_COUNTING);
    cl_kernel hits_kernel = probe_kernel(program, "probe_hits");
    cl_kernel kernel = probe_kernel(program, "render_kdtree");
    answer_functions(&probe, program);
    const SceneJob3D *job;
    for (int k = 0; (job = probe_scene3d(&probe, k)) != NULL; k++) {
        TracedScene scene = {job, probe_scene3d_buffers(&probe, k, job),
                             probe_part_create(&probe, k, "nodes"),
                             probe_part_create(&probe, k, "sphere_ids")};
        answer_hits(&probe, k, &scene, hits_kernel);
        answer_picture(&probe, k, &scene, kernel);
        probe_scene3d_release(&scene.buffers);
        CL_CHECK(clReleaseMemObject(scene.d_nodes));
        CL_CHECK(clReleaseMemObject(scene.d_sphere_ids));
    }
    CL_CHECK(clReleaseKernel(hits_kernel));
    CL_CHECK(clReleaseKernel(kernel));
    probe_close_program(&probe, program);
    return EXIT_SUCCESS;
}
