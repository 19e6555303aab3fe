// Probe of lab 09: each of the student's functions on the job's inputs, then whole scenes with
// their trees: the picture, and how much work it is.
#include "jobs_09.h"
#include "probe.h"

#include "cl_memory.h"

#include <stdlib.h>

static void answer_lits(const Probe *probe, cl_program program)
{
    if (!probe_asks(probe, "lits")) {
        return;
    }
    const cl_mem d_scene[] = {probe_part_create(probe, LIT_SCENE, "spheres"),
                              probe_part_create(probe, LIT_SCENE, "nodes"),
                              probe_part_create(probe, LIT_SCENE, "sphere_ids"),
                              probe_section_create(probe, "lit_lights")};
    probe_call(probe, program, "lits", sizeof(LitJob), sizeof(LitAnswer), d_scene, 4);
    cl_memory_release(d_scene, 4);
}

static void answer_functions(const Probe *probe, cl_program program)
{
    static const char *const leaf_arrays[] = {"block_ids", "block_spheres"};
    probe_call(probe, program, "starts", sizeof(StartJob), sizeof(Vec3), NULL, 0);
    probe_call(probe, program, "mirrors", sizeof(MirrorJob), sizeof(Vec3), NULL, 0);
    probe_call(probe, program, "shadow_rays", sizeof(ShadowRayJob), sizeof(ShadowRayAnswer), NULL,
               0);
    probe_call_with(probe, program, "blocks", sizeof(BlockJob), sizeof(BlockAnswer), leaf_arrays,
                    2);
    answer_lits(probe, program);
}

static void answer_picture(const Probe *probe, int k, const SceneJob3D *job, cl_kernel kernel)
{
    Scene3DBuffers buffers = probe_scene3d_buffers(probe, k, job);
    const cl_mem d_tree[] = {probe_part_create(probe, k, "nodes"),
                             probe_part_create(probe, k, "sphere_ids")};
    size_t n_bytes;
    const cl_int *n_bounces = probe_scene_part(probe, k, "bounces", &n_bytes);
    cl_uint argument = N_SCENE3D_ARGUMENTS;
    probe_scene3d_set(&buffers, job, kernel);
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof d_tree[0], &d_tree[0]));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof d_tree[1], &d_tree[1]));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof job->bounds, &job->bounds));
    CL_CHECK(clSetKernelArg(kernel, argument++, sizeof *n_bounces, n_bounces));
    probe_draw_counting(probe, k, kernel, buffers.d_image, job->width, job->height, argument);
    probe_scene3d_release(&buffers);
    cl_memory_release(d_tree, 2);
}

int main(void)
{
    Probe probe;
    cl_program program = probe_open_program(&probe, PROBE_PROGRAM, PROBE_COUNTING);
    cl_kernel kernel = probe_kernel(program, "render_mirrors");
    answer_functions(&probe, program);
    const SceneJob3D *job;
    for (int k = 0; (job = probe_scene3d(&probe, k)) != NULL; k++) {
        answer_picture(&probe, k, job, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    probe_close_program(&probe, program);
    return EXIT_SUCCESS;
}
