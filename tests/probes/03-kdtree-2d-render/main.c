// Probe of lab 03: getContainingChild on the job's inputs, then the student's kernel on its scenes
// and trees, with the work of each pixel counted ("work.K").
#include "probe.h"

#include "cl_memory.h"
#include "jobs_03.h"

#include <stdlib.h>

// A scene's arrays on the device, in the order of the kernel's first parameters.
enum { N_ARRAYS = 5 };
static const char *const array_names[N_ARRAYS] = {"circles", "relations", "flags", "boxes", "map"};

static void arrays_create(const Probe *probe, int k, cl_mem d_arrays[N_ARRAYS])
{
    for (int i = 0; i < N_ARRAYS; i++) {
        d_arrays[i] = probe_part_create(probe, k, array_names[i]);
    }
}

static void answer_picture(const Probe *probe, int k, const SceneJob *scene, cl_kernel kernel)
{
    cl_mem d_arrays[N_ARRAYS];
    arrays_create(probe, k, d_arrays);
    cl_mem d_image = probe_image(probe, scene->width, scene->height);
    for (cl_uint i = 0; i < N_ARRAYS; i++) {
        CL_CHECK(clSetKernelArg(kernel, i, sizeof(cl_mem), &d_arrays[i]));
    }
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 6, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 7, sizeof d_image, &d_image));
    probe_draw_counting(probe, k, kernel, d_image, scene->width, scene->height, 8);
    cl_memory_release(d_arrays, N_ARRAYS);
    CL_CHECK(clReleaseMemObject(d_image));
}

int main(void)
{
    static const char *const child_tree[] = {"children.relations", "children.boxes"};
    Probe probe;
    // The folder of the probe comes first: overlaps_N_Nearer.cl is the one there.
    cl_program program = probe_open_program(&probe, PROBE_PROGRAM,
                                            "-I probes/" LAB_NAME " -I solutions " PROBE_COUNTING);
    cl_kernel kernel = probe_kernel(program, "implicit2DRenderer_KD");
    probe_call_with(&probe, program, "children", sizeof(ChildJob), sizeof(cl_uint), child_tree, 2);
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_picture(&probe, k, scene, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    probe_close_program(&probe, program);
    return EXIT_SUCCESS;
}
