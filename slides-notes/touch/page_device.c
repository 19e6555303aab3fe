// A device in a page: OpenCL for the recorder of common/follow, with one work-item, and memory that
// is the host's. The kernels are the labs' own, compiled beside this file; there is nothing to
// build.
//
// It has the functions that common/follow and the labs' buffers call, and no others. Sizes and
// names are the course's own and fit, so nothing is checked.
// Read next: builtins.cl, record.c.
#include "camera.h"
#include "cl_setup.h"
#include "kdtree2d.h"
#include "kdtree3d.h"
#include "shading.h"
#include "sphere.h"
#include "steps/steps.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// ---- Memory -------------------------------------------------------------------------------------

// A buffer is its bytes. An image is none: nobody reads it.
static cl_mem memory_create(const void *bytes, size_t n_bytes, cl_int *error)
{
    void *memory = malloc(n_bytes);
    if (memory != NULL) {
        memcpy(memory, bytes, n_bytes);
    }
    *error = memory != NULL ? CL_SUCCESS : CL_MEM_OBJECT_ALLOCATION_FAILURE;
    return memory;
}

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t n_bytes, void *bytes,
                      cl_int *error)
{
    (void)context, (void)flags;
    return memory_create(bytes, n_bytes, error);
}

cl_mem clCreateImage(cl_context context, cl_mem_flags flags, const cl_image_format *format,
                     const cl_image_desc *description, void *pixels, cl_int *error)
{
    (void)context, (void)flags, (void)format, (void)description, (void)pixels;
    return memory_create("", 1, error);
}

cl_int clReleaseMemObject(cl_mem memory)
{
    free(memory);
    return CL_SUCCESS;
}

cl_int clEnqueueFillImage(cl_command_queue queue, cl_mem image, const void *color,
                          const size_t *origin, const size_t *region, cl_uint n_events,
                          const cl_event *events, cl_event *event)
{
    (void)queue, (void)image, (void)color, (void)origin, (void)region;
    (void)n_events, (void)events, (void)event;
    return CL_SUCCESS;
}

cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem memory, cl_bool blocking, size_t offset,
                           size_t n_bytes, void *bytes, cl_uint n_events, const cl_event *events,
                           cl_event *event)
{
    (void)queue, (void)blocking, (void)n_events, (void)events, (void)event;
    memcpy(bytes, (const char *)memory + offset, n_bytes);
    return CL_SUCCESS;
}

// ---- Kernels ------------------------------------------------------------------------------------

// An argument of a kernel: of clSetKernelArg's bytes, all that the kernels here take.
enum { MOST_ARGUMENTS = 16, ARGUMENT_BYTES = 64 };
typedef union Argument {
    void *memory;
    i32 number;
    Vec3 vector;
    Camera camera;
    BBox3D box;
    char bytes[ARGUMENT_BYTES];
} Argument;

struct _cl_kernel {
    void (*run)(const Argument *arguments);
    Argument arguments[MOST_ARGUMENTS];
};

void implicit2DRenderer_KD(const void *circles, const NodeRel *nodes_Relations,
                           const u8 *nodes_flag, const BBox2D *nodes_BBox,
                           const u32 *mapNode2Circles, i32 width, i32 height, void *image,
                           Steps *d_work);

static void search_run(const Argument *a)
{
    implicit2DRenderer_KD(a[0].memory, a[1].memory, a[2].memory, a[3].memory, a[4].memory,
                          a[5].number, a[6].number, a[7].memory, a[8].memory);
}

void render_kdtree(const Sphere *spheres, const u32 *material_ids, const Material *materials,
                   const Light *lights, i32 n_lights, Vec3 background, Camera camera, i32 width,
                   i32 height, void *image, const KdNode3 *nodes, const u32 *sphere_ids,
                   BBox3D bounds, Steps *d_work);

static void trace_run(const Argument *a)
{
    render_kdtree(a[0].memory, a[1].memory, a[2].memory, a[3].memory, a[4].number, a[5].vector,
                  a[6].camera, a[7].number, a[8].number, a[9].memory, a[10].memory, a[11].memory,
                  a[12].box, a[13].memory);
}

static const struct {
    const char *name;
    void (*run)(const Argument *arguments);
} KERNELS[] = {{"implicit2DRenderer_KD", search_run}, {"render_kdtree", trace_run}};

cl_kernel clCreateKernel(cl_program program, const char *name, cl_int *error)
{
    (void)program;
    for (size_t i = 0; i < sizeof KERNELS / sizeof *KERNELS; i++) {
        if (strcmp(KERNELS[i].name, name) == 0) {
            cl_kernel kernel = calloc(1, sizeof *kernel);
            *error = kernel != NULL ? CL_SUCCESS : CL_OUT_OF_HOST_MEMORY;
            if (kernel != NULL) {
                kernel->run = KERNELS[i].run;
            }
            return kernel;
        }
    }
    *error = CL_INVALID_KERNEL_NAME;
    return NULL;
}

cl_int clReleaseKernel(cl_kernel kernel)
{
    free(kernel);
    return CL_SUCCESS;
}

cl_int clSetKernelArg(cl_kernel kernel, cl_uint i, size_t n_bytes, const void *bytes)
{
    if (i >= MOST_ARGUMENTS || n_bytes > ARGUMENT_BYTES) {
        return CL_INVALID_ARG_SIZE;
    }
    memcpy(kernel->arguments[i].bytes, bytes, n_bytes);
    return CL_SUCCESS;
}

// The work-item at hand; get_global_id() of builtins.cl asks for it.
static size_t work_item[2];

u32 page_global_id(u32 dimension)
{
    return (u32)work_item[dimension];
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint n_dimensions,
                              const size_t *first, const size_t *size, const size_t *group,
                              cl_uint n_events, const cl_event *events, cl_event *event)
{
    (void)queue, (void)n_dimensions, (void)size, (void)group;
    (void)n_events, (void)events, (void)event;
    memcpy(work_item, first, sizeof work_item);
    kernel->run(kernel->arguments);
    return CL_SUCCESS;
}

// ---- Opening it (cl_setup.h) --------------------------------------------------------------------

int cl_setup_open(const char *device_choice, ClSetup *setup)
{
    (void)device_choice;
    *setup = (ClSetup){.device_name = "this page"};
    return 0;
}

void cl_setup_image_limit(const ClSetup *setup, size_t *max_width, size_t *max_height)
{
    (void)setup;
    *max_width = *max_height = INT32_MAX;
}

// Any program holds all kernels.
cl_program cl_setup_build(const ClSetup *setup, const char *path, const char *options)
{
    (void)setup, (void)path, (void)options;
    static char all_kernels;
    return (cl_program)&all_kernels;
}

cl_int clReleaseProgram(cl_program program)
{
    (void)program;
    return CL_SUCCESS;
}
