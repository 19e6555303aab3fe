// Buffers and images: memory of the host's (see native_cl.h). An image holds pixels of four floats,
// row after row, as all of the course's do.
//
// Read next: compile.h.
#include "native_cl.h"

#include <stdlib.h>
#include <string.h>

static cl_mem known;

int mem_is_known(cl_mem mem)
{
    cl_mem other = known;
    while (other != NULL && other != mem) {
        other = other->next;
    }
    return other != NULL;
}

size_t mem_size_at(const void *bytes)
{
    cl_mem mem = known;
    while (mem != NULL && mem->bytes != bytes) {
        mem = mem->next;
    }
    return mem != NULL ? mem->n_bytes : 0;
}

// Memory of this size, or NULL with *error set.
static cl_mem mem_new(size_t n_bytes, cl_int *error)
{
    cl_mem mem = calloc(1, sizeof *mem);
    if (n_bytes == 0) {
        *error = CL_INVALID_BUFFER_SIZE;
    } else if (mem == NULL || (mem->bytes = memory_new(n_bytes)) == NULL) {
        *error = CL_MEM_OBJECT_ALLOCATION_FAILURE;
    } else {
        mem->n_bytes = n_bytes;
        mem->next = known;
        known = mem;
        *error = CL_SUCCESS;
        return mem;
    }
    free(mem);
    return NULL;
}

cl_int clReleaseMemObject(cl_mem mem)
{
    cl_mem *link = &known;
    while (*link != NULL && *link != mem) {
        link = &(*link)->next;
    }
    if (*link == NULL) {
        return CL_INVALID_MEM_OBJECT;
    }
    *link = mem->next;
    memory_free(mem->bytes, mem->n_bytes);
    free(mem);
    return CL_SUCCESS;
}

// ---- Buffers ------------------------------------------------------------------------------------

cl_mem clCreateBuffer(cl_context context, cl_mem_flags flags, size_t n_bytes, void *h_bytes,
                      cl_int *error)
{
    (void)context;
    cl_mem mem = mem_new(n_bytes, error);
    if (mem != NULL && (flags & CL_MEM_COPY_HOST_PTR)) {
        memcpy(mem->bytes, h_bytes, n_bytes);
        memory_was_set(mem->bytes, n_bytes);
    }
    return mem;
}

cl_int clEnqueueFillBuffer(cl_command_queue queue, cl_mem buffer, const void *pattern,
                           size_t n_pattern_bytes, size_t offset, size_t n_bytes,
                           cl_uint n_waits_for, const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)n_waits_for, (void)waits_for, (void)done;
    queue_catch_up();
    for (size_t i = 0; i < n_bytes; i += n_pattern_bytes) {
        memcpy((char *)buffer->bytes + offset + i, pattern, n_pattern_bytes);
    }
    memory_was_set((char *)buffer->bytes + offset, n_bytes);
    return CL_SUCCESS;
}

cl_int clEnqueueReadBuffer(cl_command_queue queue, cl_mem buffer, cl_bool is_blocking,
                           size_t offset, size_t n_bytes, void *h_bytes, cl_uint n_waits_for,
                           const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)n_waits_for, (void)waits_for;
    if (!mem_is_known(buffer) || offset + n_bytes > buffer->n_bytes) {
        return CL_INVALID_VALUE;
    }
    return queue_copy((Copy){.to = h_bytes,
                             .from = (char *)buffer->bytes + offset,
                             .n_row_bytes = n_bytes,
                             .n_rows = 1},
                      is_blocking, done);
}

// ---- Images -------------------------------------------------------------------------------------

cl_mem clCreateImage(cl_context context, cl_mem_flags flags, const cl_image_format *format,
                     const cl_image_desc *desc, void *h_pixels, cl_int *error)
{
    (void)context, (void)flags, (void)h_pixels;
    if (format->image_channel_order != CL_RGBA || format->image_channel_data_type != CL_FLOAT) {
        *error = CL_IMAGE_FORMAT_NOT_SUPPORTED;
        return NULL;
    }
    cl_mem mem = mem_new(desc->image_width * desc->image_height * sizeof(cl_float4), error);
    if (mem != NULL) {
        mem->image = (Pixels){mem->bytes, (cl_int)desc->image_width, (cl_int)desc->image_height};
    }
    return mem;
}

// A part of an image, as commands name it: where it begins, and how long its rows are.
static cl_int part_find(cl_mem image, const size_t *origin, const size_t *region, cl_float4 **first,
                        size_t *n_row_bytes)
{
    if (!mem_is_known(image)) {
        return CL_INVALID_MEM_OBJECT;
    }
    if (region[0] == 0 || region[1] == 0 || region[2] != 1 || origin[2] != 0 ||
        origin[0] + region[0] > (size_t)image->image.width ||
        origin[1] + region[1] > (size_t)image->image.height) {
        return CL_INVALID_VALUE;
    }
    *first = image->image.pixels + origin[1] * (size_t)image->image.width + origin[0];
    *n_row_bytes = region[0] * sizeof(cl_float4);
    return CL_SUCCESS;
}

static size_t image_pitch(cl_mem image)
{
    return (size_t)image->image.width * sizeof(cl_float4);
}

cl_int clEnqueueFillImage(cl_command_queue queue, cl_mem image, const void *color,
                          const size_t *origin, const size_t *region, cl_uint n_waits_for,
                          const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)n_waits_for, (void)waits_for, (void)done;
    cl_float4 *first;
    size_t n_row_bytes;
    const cl_int error = part_find(image, origin, region, &first, &n_row_bytes);
    if (error != CL_SUCCESS) {
        return error;
    }
    queue_catch_up();
    for (size_t y = 0; y < region[1]; y++) {
        for (size_t x = 0; x < region[0]; x++) {
            memcpy(first + y * (size_t)image->image.width + x, color, sizeof *first);
        }
        memory_was_set(first + y * (size_t)image->image.width, n_row_bytes);
    }
    return CL_SUCCESS;
}

cl_int clEnqueueReadImage(cl_command_queue queue, cl_mem image, cl_bool is_blocking,
                          const size_t *origin, const size_t *region, size_t row_pitch,
                          size_t slice_pitch, void *h_pixels, cl_uint n_waits_for,
                          const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)slice_pitch, (void)n_waits_for, (void)waits_for;
    Copy copy = {.to = h_pixels, .n_rows = region[1], .from_pitch = image_pitch(image)};
    cl_float4 *first;
    const cl_int error = part_find(image, origin, region, &first, &copy.n_row_bytes);
    copy.from = first;
    // One that is shorter than a row is taken as it is, as PoCL does.
    copy.to_pitch = row_pitch != 0 ? row_pitch : copy.n_row_bytes;
    return error != CL_SUCCESS ? error : queue_copy(copy, is_blocking, done);
}

cl_int clEnqueueWriteImage(cl_command_queue queue, cl_mem image, cl_bool is_blocking,
                           const size_t *origin, const size_t *region, size_t row_pitch,
                           size_t slice_pitch, const void *h_pixels, cl_uint n_waits_for,
                           const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)slice_pitch, (void)n_waits_for, (void)waits_for;
    Copy copy = {.from = h_pixels, .n_rows = region[1], .to_pitch = image_pitch(image)};
    cl_float4 *first;
    const cl_int error = part_find(image, origin, region, &first, &copy.n_row_bytes);
    copy.to = first;
    copy.from_pitch = row_pitch != 0 ? row_pitch : copy.n_row_bytes;
    return error != CL_SUCCESS ? error : queue_copy(copy, is_blocking, done);
}

void *clEnqueueMapImage(cl_command_queue queue, cl_mem image, cl_bool is_blocking,
                        cl_map_flags flags, const size_t *origin, const size_t *region,
                        size_t *row_pitch, size_t *slice_pitch, cl_uint n_waits_for,
                        const cl_event *waits_for, cl_event *done, cl_int *error)
{
    (void)queue, (void)flags, (void)slice_pitch, (void)n_waits_for, (void)waits_for, (void)done;
    cl_float4 *first = NULL;
    size_t n_row_bytes;
    *error = part_find(image, origin, region, &first, &n_row_bytes);
    *row_pitch = image_pitch(image);
    if (is_blocking) {
        queue_catch_up();
    }
    return first;
}

cl_int clEnqueueUnmapMemObject(cl_command_queue queue, cl_mem mem, void *mapped,
                               cl_uint n_waits_for, const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)mem, (void)mapped, (void)n_waits_for, (void)waits_for, (void)done;
    return CL_SUCCESS;
}
