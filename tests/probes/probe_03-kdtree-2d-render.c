// Probe of lab 03: getContainingChild on the job's inputs, then the student's kernel on its scenes
// and trees, with the work of each pixel counted ("work.K") where that compiles.
#include "probe.h"

#include "cl_memory.h"
#include "work.h"

#include <stdlib.h>

// A scene's arrays on the device, in the order of the kernel's first parameters.
enum { N_ARRAYS = 5 };
static const char *const array_names[N_ARRAYS] = {"circles", "relations", "flags", "boxes", "map"};
enum { RELATIONS = 1, BOXES = 3 };

static void arrays_create(const Probe *probe, int k, cl_mem d_arrays[N_ARRAYS])
{
    for (int i = 0; i < N_ARRAYS; i++) {
        size_t n_bytes;
        const void *array = probe_scene_part(probe, k, array_names[i], &n_bytes);
        d_arrays[i] = cl_buffer_create(&probe->cl, array, n_bytes);
    }
}

static void arrays_release(cl_mem d_arrays[N_ARRAYS])
{
    for (int i = 0; i < N_ARRAYS; i++) {
        CL_CHECK(clReleaseMemObject(d_arrays[i]));
    }
}

static cl_mem answers_create(const Probe *probe, size_t n_bytes)
{
    cl_int error;
    cl_mem d_answers = clCreateBuffer(probe->cl.context, CL_MEM_READ_WRITE, n_bytes, NULL, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    const cl_uint ones = 0xffffffffu;
    CL_CHECK(clEnqueueFillBuffer(probe->cl.queue, d_answers, &ones, sizeof ones, 0, n_bytes, 0,
                                 NULL, NULL));
    return d_answers;
}

// Read a buffer, write it as section `name` or "name.K", and release it.
static void answer_buffer(const Probe *probe, const char *name, int k, cl_mem d_answers,
                          size_t n_bytes)
{
    void *answers = malloc(n_bytes);
    CL_CHECK(clEnqueueReadBuffer(probe->cl.queue, d_answers, CL_TRUE, 0, n_bytes, answers, 0, NULL,
                                 NULL));
    probe_answer(probe, name, k, NULL, answers, n_bytes);
    CL_CHECK(clReleaseMemObject(d_answers));
    free(answers);
}

static void answer_children(const Probe *probe, cl_program program)
{
    size_t n_bytes;
    const ChildJob *jobs = probe_job(probe, "children", &n_bytes);
    const size_t n = n_bytes / sizeof *jobs;
    cl_kernel kernel = probe_kernel(program, "probe_child");
    cl_mem d_arrays[N_ARRAYS];
    arrays_create(probe, 0, d_arrays);
    cl_mem d_jobs = cl_buffer_create(&probe->cl, jobs, n_bytes);
    cl_mem d_answers = answers_create(probe, n * sizeof(cl_uint));
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_jobs, &d_jobs));
    CL_CHECK(clSetKernelArg(kernel, 1, sizeof(cl_mem), &d_arrays[RELATIONS]));
    CL_CHECK(clSetKernelArg(kernel, 2, sizeof(cl_mem), &d_arrays[BOXES]));
    CL_CHECK(clSetKernelArg(kernel, 3, sizeof d_answers, &d_answers));
    CL_CHECK(clEnqueueNDRangeKernel(probe->cl.queue, kernel, 1, NULL, &n, NULL, 0, NULL, NULL));
    answer_buffer(probe, "children", 0, d_answers, n * sizeof(cl_uint));
    CL_CHECK(clReleaseMemObject(d_jobs));
    arrays_release(d_arrays);
    CL_CHECK(clReleaseKernel(kernel));
}

static void answer_picture(const Probe *probe, int k, const SceneJob *scene, cl_kernel kernel,
                           int counting)
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
    // Room for the work-items outside the picture too, should they not leave.
    const size_t n_work_bytes = (size_t)PROBE_IMAGE_SIDE(scene->width) *
                                (size_t)PROBE_IMAGE_SIDE(scene->height) * sizeof(Work);
    cl_mem d_work = NULL;
    if (counting) {
        d_work = answers_create(probe, n_work_bytes);
        CL_CHECK(clSetKernelArg(kernel, 8, sizeof d_work, &d_work));
    }
    probe_draw(probe, k, kernel, d_image, scene->width, scene->height);
    if (counting) {
        answer_buffer(probe, "work", k, d_work, n_work_bytes);
    }
    arrays_release(d_arrays);
    CL_CHECK(clReleaseMemObject(d_image));
}

int main(void)
{
    Probe probe;
    probe_open(&probe);
    probe_open_device(&probe);
    // Counting needs the calls in the kernel itself; code that hides them still draws, uncounted.
    const char *path = "probes/probe_" LAB_NAME ".cl";
    const char *options = PROBE_KERNEL_OPTIONS " -I " LAB_FOLDER " -I probes";
    const char *counting_options = PROBE_KERNEL_OPTIONS " -I " LAB_FOLDER " -I probes -DCOUNT_WORK";
    cl_program program = cl_setup_build(&probe.cl, path, counting_options);
    const int counting = program != NULL;
    if (!counting) {
        program = probe_build(&probe, path, options);
    }
    answer_children(&probe, program);
    cl_kernel kernel = probe_kernel(program, "implicit2DRenderer_KD");
    const SceneJob *scene;
    for (int k = 0; (scene = probe_scene(&probe, k)) != NULL; k++) {
        answer_picture(&probe, k, scene, kernel, counting);
    }
    CL_CHECK(clReleaseKernel(kernel));
    CL_CHECK(clReleaseProgram(program));
    probe_close(&probe);
    return EXIT_SUCCESS;
}
