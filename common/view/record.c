// Following a pixel (see record.h).
//
// Flow: scene -> buffers -> KERNEL -> image -> comparison. Read next: steps/steps.h.
#include "record.h"

#include "complain.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// How a line of elements begins that were asked in vain.
static const char MISSED[] = "  missed:";

// Returns NULL after the messages.
static cl_kernel kernel_build(const World *world, const WorldKernel *kernel)
{
    // The lab's kernel lies in another folder than the file that is built.
    char *options;
    const int folder_length = (int)(strrchr(kernel->path, '/') - kernel->path);
    if (asprintf(&options, "-I %.*s %s", folder_length, kernel->path, kernel->options) < 0) {
        complain("view: no memory for build options");
        exit(EXIT_FAILURE);
    }
    cl_program program = cl_setup_build(&world->lab->cl, kernel->steps_path, options);
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

int record_pixel(const World *world, const WorldKernel *kernel, int x, int y, Steps *steps)
{
    cl_kernel built = kernel_build(world, kernel);
    if (built == NULL) {
        return -1;
    }
    *steps = (Steps){0};
    const ClSetup *cl = &world->lab->cl;
    cl_int error;
    cl_mem d_steps = clCreateBuffer(cl->context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                                    sizeof *steps, steps, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    kernel->set_arguments(world, built, d_steps);
    // One work-item, which takes itself for the one of pixel x, y.
    const size_t pixel[2] = {(size_t)x, (size_t)y}, one[2] = {1, 1};
    CL_CHECK(clEnqueueNDRangeKernel(cl->queue, built, 2, pixel, one, one, 0, NULL, NULL));
    CL_CHECK(
        clEnqueueReadBuffer(cl->queue, d_steps, CL_TRUE, 0, sizeof *steps, steps, 0, NULL, NULL));
    CL_CHECK(clReleaseMemObject(d_steps));
    CL_CHECK(clReleaseKernel(built));
    return 0;
}

// ---- In words ---------------------------------------------------------------------------------

static void visit_write(const World *world, const Step *step, RecordLine *line)
{
    const char *what = step->kind == STEP_LEAF ? "leaf" : "node";
    if (world->kind == &CIRCLES) {
        snprintf(line->text, sizeof line->text, "%s %u", what, step->id);
    } else {
        snprintf(line->text, sizeof line->text, "%s %u: t %.4g to %.4g, %u wait", what, step->id,
                 step->t_min, step->t_max, step->n_waiting);
    }
}

static void end_write(const World *world, const Step *step, RecordLine *line)
{
    if (world->kind == &CIRCLES) {
        char leaf[32] = "";
        if (step->id != NO_LEAF) {
            snprintf(leaf, sizeof leaf, "leaf %u, ", step->id);
        }
        snprintf(line->text, sizeof line->text, "%scolour %.3g %.3g %.3g", leaf, step->element[0],
                 step->element[1], step->element[2]);
    } else if (isfinite(step->nearest)) {
        snprintf(line->text, sizeof line->text, "hit: sphere %u, t %.6g", step->id, step->nearest);
    } else {
        snprintf(line->text, sizeof line->text, "hit: none");
    }
}

static int is_hit(const World *world, const Step *step)
{
    return world->kind == &CIRCLES ? step->answer > 0 : isfinite(step->answer);
}

// Write an element that was asked in vain, behind the ones of the line before where there is room.
// Returns how many lines were added.
static int miss_write(int id, RecordLine *line, RecordLine *before)
{
    if (before != NULL && strncmp(before->text, MISSED, sizeof MISSED - 1) == 0) {
        const size_t length = strlen(before->text);
        char number[16];
        snprintf(number, sizeof number, " %d", id);
        if (length + strlen(number) <= RECORD_LINE_LENGTH) {
            strcpy(before->text + length, number);
            return 0;
        }
    }
    snprintf(line->text, sizeof line->text, "%s %d", MISSED, id);
    return 1;
}

// Returns how many lines were added.
static int test_write(const World *world, const Step *step, int id, RecordLine *line,
                      RecordLine *before)
{
    if (!is_hit(world, step)) {
        return miss_write(id, line, before);
    }
    if (world->kind == &CIRCLES) {
        snprintf(line->text, sizeof line->text, "  circle %d: nearest so far", id);
    } else {
        snprintf(line->text, sizeof line->text, "  sphere %d: t %.6g", id, step->answer);
    }
    return 1;
}

int record_words(const World *world, const Steps *steps, RecordLine *lines)
{
    const int n_kept = steps->n_steps < MAX_STEPS ? (int)steps->n_steps : MAX_STEPS;
    int n_lines = 0, id = -1;
    for (int i = 0; i < n_kept; i++) {
        const Step *step = &steps->steps[i];
        RecordLine *line = &lines[n_lines];
        if (step->kind == STEP_TEST) {
            // Mostly they are asked in the order of the scene.
            id = world->kind->find(world, step->element, id + 1);
            n_lines += test_write(world, step, id, line, n_lines > 0 ? line - 1 : NULL);
            continue;
        }
        if (step->kind == STEP_END && steps->n_steps > MAX_STEPS) {
            snprintf(line->text, sizeof line->text, "and %u more", steps->n_steps - MAX_STEPS);
            line = &lines[++n_lines];
        }
        if (step->kind == STEP_END) {
            end_write(world, step, line);
        } else {
            visit_write(world, step, line);
        }
        n_lines++;
    }
    return n_lines;
}
