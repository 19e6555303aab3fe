// Programs, kernels and launches (see native_cl.h): the work-items of a launch run one after the
// other, work-group by work-group.
//
// No kernel of the course has local memory or a barrier: one that has is refused, as there is no
// such function here.
#include "compile.h"
#include "message.h"
#include "native_cl.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// As the grader has PoCL take (POCL_MAX_WORK_GROUP_SIZE in run/variant_start.c).
enum { LARGEST_GROUP = 256 };

enum { N_DIMENSIONS = 3 };

// ---- Programs -----------------------------------------------------------------------------------

struct _cl_program {
    char *source;
    char *log;      // of its compiler, "" for nothing
    void *library;  // NULL before it is built
};

cl_program clCreateProgramWithSource(cl_context context, cl_uint n_texts, const char **texts,
                                     const size_t *lengths, cl_int *error)
{
    (void)context, (void)lengths;
    cl_program program = calloc(1, sizeof *program);
    *error = CL_OUT_OF_HOST_MEMORY;
    if (program != NULL && n_texts == 1) {
        program->source = strdup(texts[0]);
        program->log = strdup("");
        *error = CL_SUCCESS;
    }
    return program;
}

// What the loader says of a program, with the name of the function that it lacks. The compiler has
// that as "_Z7barrierj": the length of the name, and types behind it.
static char *missing_function(const char *says)
{
    static const char mark[] = "undefined symbol: _Z";
    const char *symbol = strstr(says, mark);
    char name[64];
    char *end = NULL;
    const long length = symbol != NULL ? strtol(symbol + strlen(mark), &end, 10) : 0;
    if (length <= 0 || length >= (long)sizeof name) {
        return strdup(says);
    }
    snprintf(name, sizeof name, "%.*s", (int)length, end);
    return message_new("a kernel calls %s(), which the course's own OpenCL for this processor does "
                       "not have\n",
                       name);
}

cl_int clBuildProgram(cl_program program, cl_uint n_devices, const cl_device_id *devices,
                      const char *options, void (*notify)(cl_program, void *), void *data)
{
    (void)n_devices, (void)devices, (void)notify, (void)data;
    free(program->log);
    program->log = NULL;
    char *path = compile_kernels(program->source, options, &program->log);
    if (path != NULL) {
        program_begins();
        // What it lacks of OpenCL's functions is said now, and not where it calls them.
        program->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
        if (program->library == NULL) {
            free(program->log);
            program->log = missing_function(dlerror());
        }
    }
    free(path);
    return program->library != NULL ? CL_SUCCESS : CL_BUILD_PROGRAM_FAILURE;
}

cl_int clGetProgramBuildInfo(cl_program program, cl_device_id device,
                             cl_program_build_info question, size_t n_room, void *to,
                             size_t *n_answered)
{
    (void)device;
    const char *log = program->log != NULL ? program->log : "";
    const size_t n_bytes = strlen(log) + 1;
    if (question != CL_PROGRAM_BUILD_LOG || (to != NULL && n_room < n_bytes)) {
        return CL_INVALID_VALUE;
    }
    if (to != NULL) {
        memcpy(to, log, n_bytes);
    }
    if (n_answered != NULL) {
        *n_answered = n_bytes;
    }
    return CL_SUCCESS;
}

cl_int clReleaseProgram(cl_program program)
{
    if (program->library != NULL) {
        dlclose(program->library);
    }
    free(program->source);
    free(program->log);
    free(program);
    return CL_SUCCESS;
}

// ---- Kernels ------------------------------------------------------------------------------------

cl_kernel clCreateKernel(cl_program program, const char *name, cl_int *error)
{
    char symbol[128];
    cl_kernel kernel = calloc(1, sizeof *kernel);
    if (kernel == NULL) {
        *error = CL_OUT_OF_HOST_MEMORY;
        return NULL;
    }
    snprintf(symbol, sizeof symbol, KERNEL_ENTRY "%s", name);
    // POSIX has dlsym() return functions as void *; C11 has no cast for that.
    void *entry = dlsym(program->library, symbol);
    memcpy(&kernel->entry, &entry, sizeof entry);
    snprintf(symbol, sizeof symbol, KERNEL_PARAMETERS "%s", name);
    kernel->parameters = dlsym(program->library, symbol);
    snprintf(symbol, sizeof symbol, KERNEL_ELEMENTS "%s", name);
    kernel->elements = dlsym(program->library, symbol);
    snprintf(symbol, sizeof symbol, KERNEL_NAMES "%s", name);
    kernel->names = dlsym(program->library, symbol);
    *error = CL_SUCCESS;
    if (kernel->entry == NULL || kernel->parameters == NULL ||
        kernel->parameters[0] > MAX_PARAMETERS) {
        free(kernel);
        kernel = NULL;
        *error = CL_INVALID_KERNEL_NAME;
    }
    return kernel;
}

cl_int clReleaseKernel(cl_kernel kernel)
{
    free(kernel);
    return CL_SUCCESS;
}

// What a kernel gets to see of the memory object at this address; a buffer may be none at all.
// Returns whether it is one of the kind.
static int mem_find(const void *at, int is_image, const void **seen)
{
    cl_mem mem = NULL;
    if (at != NULL) {
        memcpy(&mem, at, sizeof mem);
    }
    if (mem == NULL) {
        *seen = NULL;
        return !is_image;
    }
    if (!mem_is_known(mem) || is_image != (mem->image.pixels != NULL)) {
        return 0;
    }
    *seen = is_image ? (const void *)&mem->image : mem->bytes;
    return 1;
}

cl_int clSetKernelArg(cl_kernel kernel, cl_uint number, size_t n_bytes, const void *value)
{
    if (number >= kernel->parameters[0]) {
        return CL_INVALID_ARG_INDEX;
    }
    const cl_uint parameter = kernel->parameters[1 + number];
    const cl_uint kind = parameter >> PARAMETER_KIND_BIT;
    const size_t n_expected = parameter & ((1u << PARAMETER_KIND_BIT) - 1);
    if (n_bytes != n_expected || n_bytes > MAX_PARAMETER_BYTES) {
        return CL_INVALID_ARG_SIZE;
    }
    if (kind == PARAMETER_VALUE) {
        memcpy(kernel->values[number], value, n_bytes);
    } else {
        const void *seen = NULL;
        if (!mem_find(value, kind == PARAMETER_IMAGE, &seen)) {
            return CL_INVALID_MEM_OBJECT;
        }
        memcpy(kernel->values[number], &seen, sizeof seen);
    }
    kernel->is_set[number] = 1;
    return CL_SUCCESS;
}

// ---- Launches -----------------------------------------------------------------------------------

cl_kernel kernel_running;

static size_t asked[N_ASKED][N_DIMENSIONS];
static size_t offset[N_DIMENSIONS];

size_t native_item(cl_uint what, cl_uint dimension)
{
    const size_t beyond = what == ASKS_GLOBAL_SIZE || what == ASKS_LOCAL_SIZE;
    return dimension < N_DIMENSIONS ? asked[what][dimension] : beyond;
}

// Call f for each place in a box, the first dimension innermost.
//   place[3]   where it is now
static void each_place(const size_t size[N_DIMENSIONS], size_t place[N_DIMENSIONS],
                       void (*f)(cl_kernel, void *const *), cl_kernel kernel,
                       void *const *arguments)
{
    for (place[2] = 0; place[2] < size[2]; place[2]++) {
        for (place[1] = 0; place[1] < size[1]; place[1]++) {
            for (place[0] = 0; place[0] < size[0]; place[0]++) {
                f(kernel, arguments);
            }
        }
    }
}

static void run_item(cl_kernel kernel, void *const *arguments)
{
    for (int i = 0; i < N_DIMENSIONS; i++) {
        asked[ASKS_GLOBAL_ID][i] = offset[i] + asked[ASKS_GROUP_ID][i] * asked[ASKS_LOCAL_SIZE][i] +
                                   asked[ASKS_LOCAL_ID][i];
    }
    kernel->entry(arguments);
}

static void run_group(cl_kernel kernel, void *const *arguments)
{
    each_place(asked[ASKS_LOCAL_SIZE], asked[ASKS_LOCAL_ID], run_item, kernel, arguments);
}

// The group's size where the caller leaves it to us: a part of a row.
static size_t row_part(size_t n)
{
    size_t part = n < LARGEST_GROUP ? n : LARGEST_GROUP;
    while (part > 0 && n % part != 0) {
        part--;
    }
    return part > 0 ? part : 1;
}

// Note the sizes of a launch; one of no work-items is none, as in OpenCL 2.1 and PoCL. Returns
// CL_SUCCESS, or the error that OpenCL has for them.
//   n_groups[3]   out
static cl_int take_sizes(cl_uint n_dimensions, const size_t *at, const size_t *global,
                         const size_t *local, size_t n_groups[N_DIMENSIONS])
{
    size_t n_group_items = 1;
    if (n_dimensions < 1 || n_dimensions > N_DIMENSIONS) {
        return CL_INVALID_WORK_DIMENSION;
    }
    for (cl_uint i = 0; i < N_DIMENSIONS; i++) {
        const int is_there = i < n_dimensions;
        const size_t size = is_there ? global[i] : 1;
        const size_t part = !is_there ? 1 : local != NULL ? local[i] : i == 0 ? row_part(size) : 1;
        if (part == 0 || size % part != 0) {
            return CL_INVALID_WORK_GROUP_SIZE;
        }
        offset[i] = is_there && at != NULL ? at[i] : 0;
        asked[ASKS_GLOBAL_SIZE][i] = size;
        asked[ASKS_LOCAL_SIZE][i] = part;
        n_groups[i] = size / part;
        n_group_items *= part;
    }
    return n_group_items <= LARGEST_GROUP ? CL_SUCCESS : CL_INVALID_WORK_GROUP_SIZE;
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint n_dimensions,
                              const size_t *at, const size_t *global, const size_t *local,
                              cl_uint n_waits_for, const cl_event *waits_for, cl_event *done)
{
    (void)queue, (void)n_waits_for, (void)waits_for, (void)done;
    void *arguments[MAX_PARAMETERS];
    size_t n_groups[N_DIMENSIONS];
    for (cl_uint i = 0; i < kernel->parameters[0]; i++) {
        if (!kernel->is_set[i]) {
            return CL_INVALID_KERNEL_ARGS;
        }
        arguments[i] = kernel->values[i];
    }
    const cl_int error = take_sizes(n_dimensions, at, global, local, n_groups);
    if (error == CL_SUCCESS) {
        queue_catch_up();
        kernel_running = kernel;
        each_place(n_groups, asked[ASKS_GROUP_ID], run_group, kernel, arguments);
        kernel_running = NULL;
        launch_has_ended();
    }
    return error;
}
