// What all probes share. Any trouble that is not the student's ends in PROBE_EXIT_FAULT.
#include "probe.h"

#include "cl_memory.h"
#include "image_size.h"
#include "work.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

// A job is made by the grader: larger ones are a mistake of its own.
#define MAX_JOB_BYTES ((size_t)256 << 20)

// Of a function on the device.
enum { MOST_BUFFERS = 4 };

static void fault(const char *what)
{
    fprintf(stderr, "probe: %s\n", what);
    exit(PROBE_EXIT_FAULT);
}

// Memory that is a new file as well.
static void *file_in_memory(const char *path, size_t n_bytes)
{
    const int file = open(path, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (file < 0 || ftruncate(file, (off_t)n_bytes) != 0) {
        fault("nowhere to write notes");
    }
    void *memory = mmap(NULL, n_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (memory == MAP_FAILED) {
        fault("nowhere to write notes");
    }
    return memory;
}

void probe_note(const Probe *probe, const char *name, uint32_t input)
{
    *probe->note = (ProbeNote){.input = input};
    memcpy(probe->note->name, name, strnlen(name, SECTION_NAME_BYTES - 1));
}

void probe_open(Probe *probe)
{
    char job[64], answers[64];
    const char *which = getenv(PROBE_JOB_VARIABLE);
    snprintf(job, sizeof job, PROBE_JOB_PATH "%s", which ? which : "");
    snprintf(answers, sizeof answers, PROBE_ANSWERS_PATH "%s", which ? which : "");
    *probe = (Probe){0};
    if (sections_load(job, MAX_JOB_BYTES, &probe->job) != 0) {
        fault("no job");
    }
    probe->answers = fopen(answers, "w");
    if (probe->answers == NULL) {
        fault("nowhere to write answers");
    }
    probe->note = file_in_memory(PROBE_NOTE_PATH, sizeof *probe->note);
}

void probe_open_device(Probe *probe)
{
    if (cl_setup_open(NULL, &probe->cl) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    if (section_write(probe->answers, PROBE_DEVICE, probe->cl.device_name,
                      sizeof probe->cl.device_name) != 0) {
        fault("cannot write answers");
    }
}

void probe_close(Probe *probe)
{
    if (section_write(probe->answers, PROBE_END, "", 0) != 0) {
        fault("cannot write answers");
    }
    munmap(probe->note, sizeof *probe->note);
    sections_free(&probe->job);
    fclose(probe->answers);
    cl_setup_close(&probe->cl);
}

int probe_asks(const Probe *probe, const char *name)
{
    size_t n_bytes;
    return sections_find_any(&probe->job, name, &n_bytes) != NULL;
}

int probe_alone(const Probe *probe, const char *task)
{
    const char *alone = sections_find(&probe->job, PROBE_ALONE, strlen(task));
    return alone != NULL && memcmp(alone, task, strlen(task)) == 0;
}

const void *probe_job(const Probe *probe, const char *name, size_t *n_bytes)
{
    const void *bytes = sections_find_any(&probe->job, name, n_bytes);
    if (bytes == NULL) {
        fault("the job lacks a section");
    }
    return bytes;
}

// "name", "name.K" or "name.K.part" as a section's name.
static void section_name(char name[SECTION_NAME_BYTES], const char *stem, int k, const char *part)
{
    if (k < 0) {
        snprintf(name, SECTION_NAME_BYTES, "%s", stem);
        return;
    }
    snprintf(name, SECTION_NAME_BYTES, part ? "%s.%d.%s" : "%s.%d", stem, k, part);
}

const SceneJob *probe_scene(const Probe *probe, int k)
{
    char name[SECTION_NAME_BYTES];
    section_name(name, "scene", k, NULL);
    return sections_find(&probe->job, name, sizeof(SceneJob));
}

const void *probe_scene_part(const Probe *probe, int k, const char *part, size_t *n_bytes)
{
    char name[SECTION_NAME_BYTES];
    section_name(name, "scene", k, part);
    return probe_job(probe, name, n_bytes);
}

void probe_answer(const Probe *probe, const char *stem, int k, const char *part, const void *bytes,
                  size_t n_bytes)
{
    char name[SECTION_NAME_BYTES];
    section_name(name, stem, k, part);
    if (section_write(probe->answers, name, bytes, n_bytes) != 0) {
        fault("cannot write answers");
    }
}

void probe_answer_array(const Probe *probe, const char *name, void *array, size_t n_bytes)
{
    probe_answer(probe, name, -1, NULL, array, n_bytes);
    free(array);
}

void probe_leave_untouched(uint32_t *array, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        array[i] = UNTOUCHED;
    }
}

cl_program probe_build(const Probe *probe, const char *path, const char *options)
{
    probe_note(probe, PROBE_NOTE_BUILD, PROBE_NO_INPUT);
    cl_program program = cl_setup_build(&probe->cl, path, options);
    if (program == NULL) {
        exit(PROBE_EXIT_NO_BUILD);
    }
    return program;
}

cl_kernel probe_kernel(cl_program program, const char *name)
{
    cl_int error;
    cl_kernel kernel = clCreateKernel(program, name, &error);
    if (error == CL_INVALID_KERNEL_NAME) {
        fprintf(stderr, "no kernel called %s\n", name);
        exit(PROBE_EXIT_NO_BUILD);
    }
    CL_CHECK_CREATED(error, clCreateKernel);
    return kernel;
}

cl_program probe_open_program(Probe *probe, const char *path, const char *options)
{
    probe_open(probe);
    probe_open_device(probe);
    return probe_build(probe, path, options);
}

void probe_close_program(Probe *probe, cl_program program)
{
    CL_CHECK(clReleaseProgram(program));
    probe_close(probe);
}

cl_mem probe_section_create(const Probe *probe, const char *name)
{
    size_t n_bytes;
    const void *bytes = probe_job(probe, name, &n_bytes);
    return cl_buffer_create(&probe->cl, bytes, n_bytes);
}

cl_mem probe_part_create(const Probe *probe, int k, const char *part)
{
    char name[SECTION_NAME_BYTES];
    section_name(name, "scene", k, part);
    return probe_section_create(probe, name);
}

cl_mem probe_buffer(const Probe *probe, size_t n_bytes)
{
    cl_int error;
    cl_mem d_answers = clCreateBuffer(probe->cl.context, CL_MEM_READ_WRITE, n_bytes, NULL, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    const cl_uint ones = 0xffffffffu;
    CL_CHECK(clEnqueueFillBuffer(probe->cl.queue, d_answers, &ones, sizeof ones, 0, n_bytes, 0,
                                 NULL, NULL));
    return d_answers;
}

void probe_answer_buffer(const Probe *probe, const char *name, int k, cl_mem d_answers,
                         size_t n_bytes)
{
    void *answers = malloc(n_bytes);
    if (answers == NULL) {
        fault("no memory");
    }
    CL_CHECK(clEnqueueReadBuffer(probe->cl.queue, d_answers, CL_TRUE, 0, n_bytes, answers, 0, NULL,
                                 NULL));
    probe_answer(probe, name, k, NULL, answers, n_bytes);
    CL_CHECK(clReleaseMemObject(d_answers));
    free(answers);
}

// Is the device a processor, which works on a program's own memory?
static int is_processor(const Probe *probe)
{
    cl_device_type type;
    return clGetDeviceInfo(probe->cl.device, CL_DEVICE_TYPE, sizeof type, &type, NULL) ==
               CL_SUCCESS &&
           (type & CL_DEVICE_TYPE_CPU) != 0;
}

// Room for n answers, as probe_buffer(). On a processor it is memory that is a file as well, and
// noted: if the program ends there, the file tells which input was the last.
static cl_mem answers_create(const Probe *probe, size_t n, size_t answer_bytes, void **memory)
{
    const size_t n_bytes = n * answer_bytes;
    *memory = NULL;
    if (!is_processor(probe)) {
        return probe_buffer(probe, n_bytes);
    }
    *memory = file_in_memory(PROBE_ANSWERING_PATH, n_bytes);
    memset(*memory, 0xff, n_bytes);
    cl_int error;
    cl_mem d_answers = clCreateBuffer(probe->cl.context, CL_MEM_READ_WRITE | CL_MEM_USE_HOST_PTR,
                                      n_bytes, *memory, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    probe->note->n_together = (uint32_t)n;
    return d_answers;
}

void probe_call(const Probe *probe, cl_program program, const char *name, size_t job_bytes,
                size_t answer_bytes, const cl_mem *d_buffers, cl_uint n_buffers)
{
    char kernel_name[64];
    if (!probe_asks(probe, name)) {
        return;
    }
    snprintf(kernel_name, sizeof kernel_name, "probe_%s", name);
    probe_note(probe, name, PROBE_NO_INPUT);
    size_t n_bytes;
    const void *jobs = probe_job(probe, name, &n_bytes);
    const size_t n = n_bytes / job_bytes;
    cl_kernel kernel = probe_kernel(program, kernel_name);
    cl_mem d_jobs = cl_buffer_create(&probe->cl, jobs, n_bytes);
    void *memory;
    cl_mem d_answers = answers_create(probe, n, answer_bytes, &memory);
    CL_CHECK(clSetKernelArg(kernel, 0, sizeof d_jobs, &d_jobs));
    for (cl_uint i = 0; i < n_buffers; i++) {
        CL_CHECK(clSetKernelArg(kernel, 1 + i, sizeof d_buffers[i], &d_buffers[i]));
    }
    CL_CHECK(clSetKernelArg(kernel, 1 + n_buffers, sizeof d_answers, &d_answers));
    // In groups of one: a processor then takes them one after the other.
    const size_t alone = 1;
    CL_CHECK(clEnqueueNDRangeKernel(probe->cl.queue, kernel, 1, NULL, &n, &alone, 0, NULL, NULL));
    probe_answer_buffer(probe, name, -1, d_answers, n * answer_bytes);
    if (memory != NULL) {
        munmap(memory, n * answer_bytes);
    }
    CL_CHECK(clReleaseMemObject(d_jobs));
    CL_CHECK(clReleaseKernel(kernel));
}

void probe_call_with(const Probe *probe, cl_program program, const char *name, size_t job_bytes,
                     size_t answer_bytes, const char *const *buffers, cl_uint n_buffers)
{
    cl_mem d_buffers[MOST_BUFFERS] = {NULL};
    for (cl_uint i = 0; probe_asks(probe, name) && i < n_buffers; i++) {
        d_buffers[i] = probe_section_create(probe, buffers[i]);
    }
    probe_call(probe, program, name, job_bytes, answer_bytes, d_buffers, n_buffers);
    cl_memory_release(d_buffers, n_buffers);
}

cl_mem probe_image(const Probe *probe, int width, int height)
{
    const cl_float4 color = {{UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN}};
    const size_t corner[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)PROBE_IMAGE_SIDE(width), (size_t)PROBE_IMAGE_SIDE(height), 1};
    cl_mem d_image;
    if (cl_image_create(&probe->cl, PROBE_IMAGE_SIDE(width), PROBE_IMAGE_SIDE(height), &d_image) !=
        0) {
        fault("no image");
    }
    CL_CHECK(clEnqueueFillImage(probe->cl.queue, d_image, &color, corner, region, 0, NULL, NULL));
    return d_image;
}

void probe_launch(const Probe *probe, cl_kernel kernel, int width, int height)
{
    const size_t group[3] = {16, 16, 1};
    const size_t items[3] = {(size_t)PROBE_IMAGE_SIDE(width), (size_t)PROBE_IMAGE_SIDE(height), 1};
    const size_t offset[3] = {0, 0, PROBE_SIZE_OFFSET(width, height)};
    CL_CHECK(
        clEnqueueNDRangeKernel(probe->cl.queue, kernel, 3, offset, items, group, 0, NULL, NULL));
}

void probe_draw_rows(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width,
                     int height)
{
    const size_t n_items = (size_t)width * (size_t)height;
    probe_note(probe, "picture", (uint32_t)k);
    CL_CHECK(
        clEnqueueNDRangeKernel(probe->cl.queue, kernel, 1, NULL, &n_items, NULL, 0, NULL, NULL));
    probe_answer_image(probe, k, d_image, width, height);
}

void probe_draw(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width, int height)
{
    probe_note(probe, "picture", (uint32_t)k);
    probe_launch(probe, kernel, width, height);
    probe_answer_image(probe, k, d_image, width, height);
}

void probe_draw_counting(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width,
                         int height, cl_uint argument)
{
    const size_t n_bytes =
        (size_t)PROBE_IMAGE_SIDE(width) * (size_t)PROBE_IMAGE_SIDE(height) * sizeof(Work);
    cl_mem d_work = probe_buffer(probe, n_bytes);
    CL_CHECK(clSetKernelArg(kernel, argument, sizeof d_work, &d_work));
    probe_draw(probe, k, kernel, d_image, width, height);
    probe_answer_buffer(probe, "work", k, d_work, n_bytes);
}

const void *probe_map_image(const Probe *probe, cl_mem d_image, const size_t region[3],
                            size_t *n_row_bytes)
{
    const size_t corner[3] = {0, 0, 0};
    cl_int error;
    const void *mapped = clEnqueueMapImage(probe->cl.queue, d_image, CL_TRUE, CL_MAP_READ, corner,
                                           region, n_row_bytes, NULL, 0, NULL, NULL, &error);
    CL_CHECK_CREATED(error, clEnqueueMapImage);
    return mapped;
}

void probe_unmap_image(const Probe *probe, cl_mem d_image, const void *mapped)
{
    // OpenCL takes the pointer back as it gave it, without const.
    CL_CHECK(clEnqueueUnmapMemObject(probe->cl.queue, d_image, (void *)mapped, 0, NULL, NULL));
    CL_CHECK(clFinish(probe->cl.queue));
}

void probe_answer_image(const Probe *probe, int k, cl_mem d_image, int width, int height)
{
    const size_t region[3] = {(size_t)PROBE_IMAGE_SIDE(width), (size_t)PROBE_IMAGE_SIDE(height), 1};
    const size_t n_row_bytes = region[0] * sizeof(cl_float4);
    char *h_pixels = malloc(region[1] * n_row_bytes);
    if (h_pixels == NULL) {
        fault("no memory");
    }
    size_t pitch;
    const char *mapped = probe_map_image(probe, d_image, region, &pitch);
    for (size_t y = 0; y < region[1]; y++) {
        memcpy(h_pixels + y * n_row_bytes, mapped + y * pitch, n_row_bytes);
    }
    probe_unmap_image(probe, d_image, mapped);
    probe_answer(probe, "picture", k, NULL, h_pixels, region[1] * n_row_bytes);
    free(h_pixels);
}

// ---- 3D -----------------------------------------------------------------------------------------

const SceneJob3D *probe_scene3d(const Probe *probe, int k)
{
    char name[SECTION_NAME_BYTES];
    section_name(name, "scene", k, NULL);
    return sections_find(&probe->job, name, sizeof(SceneJob3D));
}

Scene3DBuffers probe_scene3d_buffers(const Probe *probe, int k, const SceneJob3D *scene)
{
    static const char *const names[N_SCENE3D_ARRAYS] = {"spheres", "material_ids", "materials",
                                                        "lights"};
    Scene3DBuffers buffers = {.d_image = probe_image(probe, scene->width, scene->height)};
    for (int i = 0; i < N_SCENE3D_ARRAYS; i++) {
        buffers.d_arrays[i] = probe_part_create(probe, k, names[i]);
    }
    return buffers;
}

void probe_scene3d_release(Scene3DBuffers *buffers)
{
    cl_memory_release(buffers->d_arrays, N_SCENE3D_ARRAYS);
    CL_CHECK(clReleaseMemObject(buffers->d_image));
}

void probe_scene3d_set(const Scene3DBuffers *buffers, const SceneJob3D *scene, cl_kernel kernel)
{
    for (cl_uint i = 0; i < N_SCENE3D_ARRAYS; i++) {
        CL_CHECK(clSetKernelArg(kernel, i, sizeof(cl_mem), &buffers->d_arrays[i]));
    }
    CL_CHECK(clSetKernelArg(kernel, 4, sizeof scene->n_lights, &scene->n_lights));
    CL_CHECK(clSetKernelArg(kernel, 5, sizeof scene->background, &scene->background));
    CL_CHECK(clSetKernelArg(kernel, 6, sizeof scene->camera, &scene->camera));
    CL_CHECK(clSetKernelArg(kernel, 7, sizeof scene->width, &scene->width));
    CL_CHECK(clSetKernelArg(kernel, 8, sizeof scene->height, &scene->height));
    CL_CHECK(clSetKernelArg(kernel, 9, sizeof buffers->d_image, &buffers->d_image));
}
