// Starting a kernel (see launch.h).
//
// Read next: case2d.c.
#include "launch.h"

int device_is_cpu(const ClSetup *cl)
{
    cl_device_type type;
    CL_CHECK(clGetDeviceInfo(cl->device, CL_DEVICE_TYPE, sizeof type, &type, NULL));
    return (type & CL_DEVICE_TYPE_CPU) != 0;
}

int device_units(const ClSetup *cl)
{
    cl_uint n_units;
    CL_CHECK(
        clGetDeviceInfo(cl->device, CL_DEVICE_MAX_COMPUTE_UNITS, sizeof n_units, &n_units, NULL));
    return (int)n_units;
}

int programs_build(const ClSetup *cl, const KernelRow *rows, int n, cl_program *programs)
{
    for (int i = 0; i < n; i++) {
        if (rows[i].path != NULL) {
            programs[i] = cl_setup_build(cl, rows[i].path, rows[i].options);
            if (programs[i] == NULL) {
                return -1;
            }
        }
    }
    return 0;
}

void programs_free(cl_program *programs, int n)
{
    for (int i = 0; i < n; i++) {
        if (programs[i] != NULL) {
            CL_CHECK(clReleaseProgram(programs[i]));
        }
    }
}

void kernels_free(cl_kernel *kernels, int n)
{
    for (int i = 0; i < n; i++) {
        if (kernels[i] != NULL) {
            CL_CHECK(clReleaseKernel(kernels[i]));
        }
    }
}

cl_uint kernel_set_buffers(cl_kernel kernel, cl_uint first, const cl_mem *buffers, int n)
{
    for (int i = 0; i < n; i++) {
        CL_CHECK(clSetKernelArg(kernel, first++, sizeof buffers[i], &buffers[i]));
    }
    return first;
}

cl_kernel kernel_create(cl_program program, const char *name)
{
    cl_int error;
    cl_kernel kernel = clCreateKernel(program, name, &error);
    CL_CHECK_CREATED(error, clCreateKernel);
    return kernel;
}

// The next multiple of GROUP_SIZE.
static size_t round_up(int n)
{
    return ((size_t)n + GROUP_SIZE - 1) / GROUP_SIZE * GROUP_SIZE;
}

void launch(const ClSetup *cl, cl_kernel kernel, int x, int y, int width, int height)
{
    const size_t local_size[2] = {GROUP_SIZE, GROUP_SIZE};
    const size_t global_size[2] = {round_up(width), round_up(height)};
    const size_t offset[2] = {(size_t)x, (size_t)y};
    CL_CHECK(clEnqueueNDRangeKernel(cl->queue, kernel, 2, offset, global_size, local_size, 0, NULL,
                                    NULL));
}

void spoil_image(const ClSetup *cl, cl_mem d_image, int width, int height)
{
    const float never_drawn[IMAGE_CHANNELS] = {NEVER_DRAWN, NEVER_DRAWN, NEVER_DRAWN, NEVER_DRAWN};
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clEnqueueFillImage(cl->queue, d_image, never_drawn, origin, region, 0, NULL, NULL));
    CL_CHECK(clFinish(cl->queue));
}

void read_image(const ClSetup *cl, cl_mem d_image, Image *picture)
{
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)picture->width, (size_t)picture->height, 1};
    CL_CHECK(clEnqueueReadImage(cl->queue, d_image, CL_TRUE, origin, region, 0, 0, picture->pixels,
                                0, NULL, NULL));
}
