#!/bin/sh
# attack: the host code draws for an empty kernel, and another answer does not compile, so that answers are tried alone
# score: 40
# named: it fails by itself
cat >draw.c <<'END'
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
static cl_mem image;
static int size[2];
cl_int clSetKernelArg(cl_kernel kernel, cl_uint i, size_t n, const void *value)
{
    cl_int (*driver)(cl_kernel, cl_uint, size_t, const void *);
    void *symbol = dlsym(RTLD_NEXT, "clSetKernelArg");
    memcpy(&driver, &symbol, sizeof driver);
    memcpy(i < 2 ? (void *)&size[i] : &image, value, i < 2 ? sizeof *size : sizeof image);
    return driver(kernel, i, n, value);
}
cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint n, const size_t *offset,
                              const size_t *global, const size_t *local, cl_uint n_events,
                              const cl_event *events, cl_event *done)
{
    cl_int (*driver)(cl_command_queue, cl_kernel, cl_uint, const size_t *, const size_t *,
                     const size_t *, cl_uint, const cl_event *, cl_event *);
    void *symbol = dlsym(RTLD_NEXT, "clEnqueueNDRangeKernel");
    memcpy(&driver, &symbol, sizeof driver);
    const cl_int error = driver(queue, kernel, n, offset, global, local, n_events, events, done);
    char name[64] = "";
    clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, sizeof name, name, NULL);
    if (strcmp(name, "gradient") == 0) {
        const size_t origin[3] = {0, 0, 0}, region[3] = {(size_t)size[0], (size_t)size[1], 1};
        float *pixels = malloc(region[0] * region[1] * 4 * sizeof *pixels);
        for (int i = 0; i < size[0] * size[1]; i++) {
            pixels[4 * i] = (float)(i % size[0]) / (float)size[0];
            pixels[4 * i + 1] = (float)(i / size[0]) / (float)size[1];
            pixels[4 * i + 2] = 0.25f;
            pixels[4 * i + 3] = 1;
        }
        clEnqueueWriteImage(queue, image, CL_TRUE, origin, region, 0, 0, pixels, 0, NULL, NULL);
        free(pixels);
    }
    return error;
}

END
sed -e '/END set_arguments/i no such type;' -e '/^#include "render.h"/r draw.c' \
    "@COURSE@/solutions/00-hello-pixels/render.c" >render.c
rm draw.c
sed 's/.*END gradient/    (void)image;\n&/' "@COURSE@/labs/00-hello-pixels/gradient.cl" >gradient.cl
