// What all probes share. Any trouble that is not the student's ends in PROBE_EXIT_FAULT.
#include "probe.h"

#include "cl_memory.h"

#include <stdlib.h>

// A job is made by the grader: larger ones are a mistake of its own.
#define MAX_JOB_BYTES ((size_t)256 << 20)

static void fault(const char *what)
{
    fprintf(stderr, "probe: %s\n", what);
    exit(PROBE_EXIT_FAULT);
}

void probe_open(Probe *probe)
{
    *probe = (Probe){0};
    if (sections_load(PROBE_JOB_PATH, MAX_JOB_BYTES, &probe->job) != 0) {
        fault("no job");
    }
    probe->answers = fopen(PROBE_ANSWERS_PATH, "w");
    if (probe->answers == NULL) {
        fault("nowhere to write answers");
    }
}

void probe_open_device(Probe *probe)
{
    if (cl_setup_open(NULL, &probe->cl) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    if (section_write(probe->answers, "device", probe->cl.device_name,
                      sizeof probe->cl.device_name) != 0) {
        fault("cannot write answers");
    }
}

void probe_close(Probe *probe)
{
    if (section_write(probe->answers, PROBE_END, "", 0) != 0) {
        fault("cannot write answers");
    }
    sections_free(&probe->job);
    fclose(probe->answers);
    cl_setup_close(&probe->cl);
}

const void *probe_job(const Probe *probe, const char *name, size_t *n_bytes)
{
    const void *bytes = sections_find_any(&probe->job, name, n_bytes);
    if (bytes == NULL) {
        fault("the job lacks a section");
    }
    return bytes;
}

// "name.K" or "name.K.part" as a section's name.
static void section_name(char name[SECTION_NAME_BYTES], const char *stem, int k, const char *part)
{
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

cl_program probe_build(const Probe *probe, const char *path, const char *options)
{
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

cl_mem probe_image(const Probe *probe, int width, int height)
{
    const cl_float4 color = {{UNWRITTEN, UNWRITTEN, UNWRITTEN, UNWRITTEN}};
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)PROBE_IMAGE_SIDE(width), (size_t)PROBE_IMAGE_SIDE(height), 1};
    cl_mem d_image = cl_image_create(&probe->cl, PROBE_IMAGE_SIDE(width), PROBE_IMAGE_SIDE(height));
    if (d_image == NULL) {
        fault("no image");
    }
    CL_CHECK(clEnqueueFillImage(probe->cl.queue, d_image, &color, origin, region, 0, NULL, NULL));
    return d_image;
}

void probe_draw(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width, int height)
{
    const size_t local_size[2] = {16, 16};
    const size_t global_size[2] = {(size_t)PROBE_IMAGE_SIDE(width),
                                   (size_t)PROBE_IMAGE_SIDE(height)};
    CL_CHECK(clEnqueueNDRangeKernel(probe->cl.queue, kernel, 2, NULL, global_size, local_size, 0,
                                    NULL, NULL));
    probe_answer_image(probe, k, d_image, width, height);
}

void probe_answer_image(const Probe *probe, int k, cl_mem d_image, int width, int height)
{
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)PROBE_IMAGE_SIDE(width), (size_t)PROBE_IMAGE_SIDE(height), 1};
    const size_t n_bytes = region[0] * region[1] * sizeof(cl_float4);
    float *h_pixels = malloc(n_bytes);
    if (h_pixels == NULL) {
        fault("no memory");
    }
    CL_CHECK(clEnqueueReadImage(probe->cl.queue, d_image, CL_TRUE, origin, region, 0, 0, h_pixels,
                                0, NULL, NULL));
    probe_answer(probe, "picture", k, NULL, h_pixels, n_bytes);
    free(h_pixels);
}
