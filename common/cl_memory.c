// Device memory: clCreateImage and clCreateBuffer with the course's one format and its limits (see
// cl_memory.h).
//
// Read next: lab.c, where the kernel draws into it.
#include "cl_memory.h"

#include "complain.h"

#include <stdio.h>

int cl_image_check_size(const ClSetup *cl, int width, int height)
{
    size_t max_width, max_height;
    cl_setup_image_limit(cl, &max_width, &max_height);
    if ((size_t)width > max_width || (size_t)height > max_height) {
        // The scene's file may say it, too.
        complain("the picture's size: found %dx%d, expected at most %zux%zu on this device (%s): "
                 "choose a smaller --size",
                 width, height, max_width, max_height, cl->device_name);
        return -1;
    }
    return 0;
}

int cl_image_create(const ClSetup *cl, int width, int height, cl_mem *d_image)
{
    *d_image = NULL;
    if (cl_image_check_size(cl, width, height) != 0) {
        return -1;
    }
    const cl_image_format format = {CL_RGBA, CL_FLOAT};
    const cl_image_desc desc = {.image_type = CL_MEM_OBJECT_IMAGE2D,
                                .image_width = (size_t)width,
                                .image_height = (size_t)height};
    cl_int error;
    *d_image = clCreateImage(cl->context, CL_MEM_WRITE_ONLY, &format, &desc, NULL, &error);
    CL_CHECK_CREATED(error, clCreateImage);

    // New memory holds whatever was there. A pixel that no work-item writes shall be black.
    const cl_float4 black = {{0, 0, 0, 0}};
    const size_t origin[3] = {0, 0, 0};
    const size_t region[3] = {(size_t)width, (size_t)height, 1};
    CL_CHECK(clEnqueueFillImage(cl->queue, *d_image, &black, origin, region, 0, NULL, NULL));
    return 0;
}

cl_mem cl_buffer_create(const ClSetup *cl, const void *h_bytes, size_t n_bytes)
{
    static const char unused_byte = 0;
    cl_int error;
    cl_mem d_buffer = clCreateBuffer(cl->context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR,
                                     n_bytes ? n_bytes : sizeof unused_byte,
                                     (void *)(n_bytes ? h_bytes : &unused_byte), &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    return d_buffer;
}

void cl_memory_release(const cl_mem *objects, size_t n_objects)
{
    for (size_t i = 0; i < n_objects; i++) {
        if (objects[i] != NULL) {
            CL_CHECK(clReleaseMemObject(objects[i]));
        }
    }
}
