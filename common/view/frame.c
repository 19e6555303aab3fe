// One frame (see frame.h). enqueue_pixels() and read_back() are those of lab 00 (render.h).
//
// Read next: world.h.
#include "frame.h"

#include "complain.h"
#include "render.h"

#include <stdio.h>
#include <string.h>

int frame_open(Frame *frame, const World *world)
{
    *frame = (Frame){0};
    if (image_create(world->width, world->height, &frame->picture) != 0) {
        return -1;
    }
    const size_t n_pixels = (size_t)world->width * (size_t)world->height;
    frame->h_work = world_allocate(n_pixels * sizeof *frame->h_work);
    frame->d_work = work_buffer_create(&world->lab->cl, world->width, world->height);
    return 0;
}

static void kernels_release(cl_kernel *built)
{
    for (int i = 0; i < LAB_MAX_KERNELS; i++) {
        if (built[i] != NULL) {
            CL_CHECK(clReleaseKernel(built[i]));
        }
    }
}

void frame_close(Frame *frame)
{
    kernels_release(frame->built);
    if (frame->d_work != NULL) {
        CL_CHECK(clReleaseMemObject(frame->d_work));
    }
    image_free(&frame->picture);
    free(frame->h_work);
    *frame = (Frame){0};
}

// Returns the kernel, or NULL after the messages.
static cl_kernel kernel_build(const World *world, const WorldKernel *kernel, const char *more)
{
    char *options;
    if (asprintf(&options, "%s%s", world_kernel_options(world, kernel), more) < 0) {
        complain("view: no memory for build options");
        exit(EXIT_FAILURE);
    }
    cl_program program = cl_setup_build(&world->lab->cl, kernel->path, options);
    free(options);
    if (program == NULL) {
        return NULL;
    }
    cl_int error;
    cl_kernel built = clCreateKernel(program, kernel->function, &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    CL_CHECK(clReleaseProgram(program));
    return built;
}

int frame_use(Frame *frame, const World *world, const WorldKernel *kernel)
{
    cl_kernel built[LAB_MAX_KERNELS] = {
        [LAB_DRAWS] = kernel_build(world, kernel, ""),
    };
    // What does not build is reported once.
    if (built[LAB_DRAWS] != NULL) {
        built[LAB_COUNTS] = kernel_build(world, kernel, " -DCOUNT_WORK");
    }
    if (built[LAB_COUNTS] == NULL) {
        kernels_release(built);
        return -1;
    }
    kernels_release(frame->built);
    memcpy(frame->built, built, sizeof built);
    frame->kernel = kernel;
    return 0;
}

// Launch one of the two kernels and wait. Returns how long it took, milliseconds.
static double run(const Frame *frame, const World *world, int which)
{
    cl_command_queue queue = world->lab->cl.queue;
    cl_kernel kernel = frame->built[which];
    frame->kernel->set_arguments(world, kernel, which == LAB_COUNTS ? frame->d_work : NULL);
    const double start = stats_clock_ms();
    EnqueuePixels *enqueue = frame->kernel->enqueue;
    (enqueue != NULL ? enqueue : enqueue_pixels)(queue, kernel, world->width, world->height);
    CL_CHECK(clFinish(queue));
    return stats_clock_ms() - start;
}

void frame_draw(Frame *frame, const World *world)
{
    frame->draw_ms = run(frame, world, LAB_DRAWS);
    if (frame->kernel->read != NULL) {
        frame->kernel->read(world, &frame->picture);
    } else {
        read_back(world->lab->cl.queue, world->d_image, world->width, world->height,
                  frame->picture.pixels);
    }
}

void frame_count(Frame *frame, const World *world)
{
    run(frame, world, LAB_COUNTS);
    const size_t n_pixels = (size_t)world->width * (size_t)world->height;
    CL_CHECK(clEnqueueReadBuffer(world->lab->cl.queue, frame->d_work, CL_TRUE, 0,
                                 n_pixels * sizeof *frame->h_work, frame->h_work, 0, NULL, NULL));
    WorkFigures figures = {0};
    for (size_t i = 0; i < n_pixels; i++) {
        const Work *work = &frame->h_work[i];
        const u32 counters[N_COUNTERS] = {work->n_tests, work->n_nodes_visited,
                                          work->n_leaves_visited, work->stack_depth};
        for (int c = 0; c < N_COUNTERS; c++) {
            figures.mean[c] += (double)counters[c] / (double)n_pixels;
            figures.most[c] = counters[c] > figures.most[c] ? counters[c] : figures.most[c];
        }
        const u32 steps = work_steps(work);
        figures.most_steps = steps > figures.most_steps ? steps : figures.most_steps;
    }
    frame->work = figures;
}

void frame_heat_map(const Frame *frame, Image *heat)
{
    const size_t n_pixels = (size_t)heat->width * (size_t)heat->height;
    const u32 brightest = frame->work.most_steps > 0 ? frame->work.most_steps : 1;
    for (size_t i = 0; i < n_pixels; i++) {
        float *pixel = heat->pixels + i * IMAGE_CHANNELS;
        image_heat_colour((float)work_steps(&frame->h_work[i]) / (float)brightest, pixel);
        pixel[3] = 1;
    }
}
