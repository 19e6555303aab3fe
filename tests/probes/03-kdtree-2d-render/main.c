// Probe of lab 03: getContainingChild on the job's inputs, then the student's kernel on its scenes
// and trees, with the work of each pixel counted ("work.K").
#include "probe.h"

#include "cl_memory.h"

#include <stdlib.h>

// A scene's arrays on the device, in the order of the kernel's first parameters.
enum { N_ARRAYS = 5 };
static const char *const array_names[N_ARRAYS] = {"circles", "relations", "flags", "boxes", "map"};

static cl_mem section_create(const Probe *probe, const char *name)
{
    size_t n_bytes;
    const void *bytes = probe_job(probe, name, &n_bytes);
    return cl_buffer_create(&probe->cl, bytes, n_bytes);
}

static void arrays_create(const Probe *probe, int k, cl_mem d_arrays[N_ARRAYS])
{
    for (int i = 0; i < N_ARRAYS; i++) {
        size_t n_bytes;
        const void *bytes = probe_scene_part(probe, k, array_names[i], &n_bytes);
        d_arrays[i] = cl_buffer_create(&probe->cl, bytes, n_bytes);
    }
}

static void arrays_release(cl_mem d_arrays[N_ARRAYS])
{
    for (int i = 0; i < N_ARRAYS; i++) {
        CL_CHECK(clReleaseMemObject(d_arrays[i]));
    }
}

static void answer_children(const Probe *probe, cl_program program)
{
    if (!probe_asks(probe, "children")) {
        return;
    }
    const cl_mem d_tree[] = {section_create(probe, "children.relations"),
                             section_create(probe, "children.boxes")};
    probe_call(probe, program, "children", sizeof(ChildJob), sizeof(cl_uint), d_tree, 2);
    CL_CHECK(clReleaseMemObject(d_tree[0]));
    CL_CHECK(clReleaseMemObject(d_tree[1]));
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
    arrays_release(d_arrays);
    CL_CHECK(clReleaseMemObject(d_image));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    probe_open_device(&probe);
    cl_program program =
        probe_build(&probe, "probes/" LAB_NAME "/probe.cl",
                    PROBE_KERNEL_OPTIONS " -I " LAB_FOLDER " -I probes -DCOUNT_WORK");
    cl_kernel kernel = probe_kernel(program, "implicit2DRenderer_KD");
    answer_children(&probe, program);
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_picture(&probe, k, scene, kernel);
    }
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    probe_close(&probe);
    return EXIT_SUCCESS;
}
