// Following a pixel (see record.h).
//
// Read next: steps/steps.h.
#include "record.h"

#include "complain.h"

#include <stdio.h>
#include <string.h>

// Returns NULL after the messages.
static cl_kernel kernel_build(const World *world, const WorldKernel *kernel)
{
    // The lab's kernel lies in another folder than the file that is built.
    char *options;
    const int folder_length = (int)(strrchr(kernel->path, '/') - kernel->path);
    if (asprintf(&options, "-I %.*s %s", folder_length, kernel->path,
                 world_kernel_options(world, kernel)) < 0) {
        complain("no memory for build options");
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

// What the kernel does not know: which of the scene's elements was asked.
static void elements_find(const World *world, Steps *steps)
{
    int id = -1;
    for (u32 i = 0; i < steps_kept(steps->n_steps); i++) {
        Step *step = &steps->steps[i];
        if (step->kind == STEP_TEST) {
            // Mostly they are asked in the order of the scene.
            id = world->kind->find(world, step->element, id + 1);
            step->id = (u32)id;  // -1 is NO_ID
        }
    }
}

// A step for the leaf of a pixel in 2D, where no function reports it: behind the last node.
static void leaf_insert(Steps *steps)
{
    const u32 n_kept = steps_kept(steps->n_steps);
    const u32 leaf = n_kept > 0 ? steps->steps[n_kept - 1].id : NO_ID;
    if (leaf == NO_ID || n_kept == MAX_STEPS) {
        return;
    }
    u32 place = 0;
    for (u32 i = 0; i < n_kept; i++) {
        place = steps->steps[i].kind == STEP_NODE ? i + 1 : place;
    }
    memmove(&steps->steps[place + 1], &steps->steps[place], (n_kept - place) * sizeof(Step));
    steps->steps[place] = (Step){.kind = STEP_LEAF, .id = leaf};
    steps->n_steps++;
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
    elements_find(world, steps);
    if (world->kind == &CIRCLES) {
        leaf_insert(steps);
    }
    return 0;
}
