// What every lab's program does besides its lesson (see lab.h).
//
// Functions stand in the order in which a main.c calls them. Read next: options.c, cl_build.c,
// work_stats.c.
#include "lab.h"

#include "cl_memory.h"
#include "complain.h"

#include <stdio.h>

void require(int result)
{
    if (result != 0) {
        exit(EXIT_FAILURE);
    }
}

Lab lab_begin(int argc, char **argv, const char *name, const char *what, int set)
{
    Lab lab = {.name = name, .set = set};
    switch (options_parse(argc, argv, name, what, set, &lab.options)) {
    case OPTIONS_BAD:
        exit(EXIT_FAILURE);
    case OPTIONS_DONE:
        exit(EXIT_SUCCESS);
    case OPTIONS_RUN:
        break;
    }
    return lab;
}

void lab_describe(Lab *lab, const char *count_name, int count, int width, int height)
{
    stats_text(&lab->stats, "lab", lab->name);
    if (lab->cl.device != NULL) {
        stats_text(&lab->stats, "device", lab->cl.device_name);
    }
    if (lab->set & (OPTIONS_SCENE | OPTIONS_SCENE3D)) {
        stats_text(&lab->stats, "scene", lab->options.scene);
    }
    if (count_name != NULL) {
        stats_integer(&lab->stats, count_name, count);
    }
    stats_integer(&lab->stats, "width", width);
    stats_integer(&lab->stats, "height", height);
}

cl_program lab_build_program(const Lab *lab, const char *path, const char *options)
{
    cl_program program = cl_setup_build(&lab->cl, path, options);
    if (program == NULL) {
        exit(EXIT_FAILURE);
    }
    return program;
}

// Build one more of the lab's kernels.
static void add_kernel(Lab *lab, const char *path, const char *name, const char *options)
{
    cl_program program = lab_build_program(lab, path, options);
    cl_int error;
    lab->kernels[lab->n_kernels++] = clCreateKernel(program, name, &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    // The kernel keeps the program as long as it needs it.
    CL_CHECK(clReleaseProgram(program));
}

void lab_build_kernels(Lab *lab, const char *path, const char *name, const char *options, int width,
                       int height)
{
    add_kernel(lab, path, name, options);
    if (!(lab->set & OPTIONS_WORK) || (lab->options.stats == NULL && !lab->options.heat_map)) {
        return;
    }
    char *counting_options;
    if (asprintf(&counting_options, "%s -DCOUNT_WORK", options) < 0) {
        complain("%s: no memory", lab->name);
        exit(EXIT_FAILURE);
    }
    add_kernel(lab, path, name, counting_options);
    free(counting_options);
    lab->d_work[LAB_COUNTS] = work_buffer_create(&lab->cl, width, height);
}

void lab_draw(Lab *lab, EnqueuePixels *enqueue, cl_kernel kernel, int width, int height)
{
    const int n_frames = lab->options.n_frames;
    double *milliseconds = stats_times_create(n_frames);
    enqueue(lab->cl.queue, kernel, width, height);
    CL_CHECK(clFinish(lab->cl.queue));
    for (int frame = 0; frame < n_frames; frame++) {
        const double start = stats_clock_ms();
        enqueue(lab->cl.queue, kernel, width, height);
        CL_CHECK(clFinish(lab->cl.queue));
        milliseconds[frame] = stats_clock_ms() - start;
    }
    stats_milliseconds(&lab->stats, "frame", milliseconds, n_frames);
    free(milliseconds);
}

void lab_count_work(Lab *lab, EnqueuePixels *enqueue, int width, int height, WorkKind kind)
{
    if (lab->n_kernels <= LAB_COUNTS) {
        return;
    }
    enqueue(lab->cl.queue, lab->kernels[LAB_COUNTS], width, height);
    require(work_report(&lab->cl, lab->d_work[LAB_COUNTS], width, height, kind,
                        lab->options.heat_map ? lab->options.output : NULL, &lab->stats));
}

void lab_end(Lab *lab)
{
    require(stats_report(&lab->stats, lab->options.stats));
    stats_free(&lab->stats);
    for (int i = 0; i < lab->n_kernels; i++) {
        CL_CHECK(clReleaseKernel(lab->kernels[i]));
    }
    cl_memory_release(lab->d_work, LAB_MAX_KERNELS);
    cl_setup_close(&lab->cl);
}
