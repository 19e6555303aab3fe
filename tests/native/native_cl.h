// A little OpenCL for the processor that this program runs on: what its files share.
//
// It has one device, one context and one queue, in which commands run when they are enqueued, on
// the thread that enqueues them. clang compiles kernels to native code, which is kept (compile.h).
// There is what probes and students' host files call, and every error that a known answer is about.
//
// Read next: launch.c, where kernels run.
#ifndef NATIVE_NATIVE_CL_H
#define NATIVE_NATIVE_CL_H

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>
#include <stddef.h>

// ---- Memory -------------------------------------------------------------------------------------

// What a kernel gets in the place of an image: NativeImage of kernels.h, as the host sees it.
typedef struct Pixels {
    cl_float4 *pixels;
    cl_int width, height;
} Pixels;

struct _cl_mem {
    void *bytes;
    size_t n_bytes;
    Pixels image;  // of a buffer, nothing
    cl_mem next;   // of those that are not released
};

// Is this a memory object, and not what a student took for one?
int mem_is_known(cl_mem mem);

// The size of the memory object whose bytes these are; 0 where there is none.
size_t mem_size_at(const void *bytes);

// What memory objects are made of: plain.c, or where the sanitizers look on, sanitized.c.
//
// Bytes for a memory object, on a multiple of 64, or NULL.
void *memory_new(size_t n_bytes);
void memory_free(void *bytes, size_t n_bytes);

// Whoever has copied or filled these bytes has set their values.
void memory_was_set(const void *bytes, size_t n_bytes);

// A program is about to be loaded, and its code may run.
void program_begins(void);

// The kernel has returned: its private variables are gone.
void launch_has_ended(void);

// ---- The queue ----------------------------------------------------------------------------------

struct _cl_event {
    cl_int status;  // CL_COMPLETE, CL_QUEUED or an error
};

// Rows of bytes that a command copies.
typedef struct Copy {
    void *to;
    const void *from;
    size_t n_row_bytes, n_rows;
    size_t to_pitch, from_pitch;  // bytes from one row to the next
    cl_event done;                // or NULL
} Copy;

// Copy now, or where the queue is held up and nobody waits, once it is not any more.
//   done   out, where it is not NULL: the event of it
cl_int queue_copy(Copy copy, cl_bool is_blocking, cl_event *done);

// Wait until all commands before this one have run.
void queue_catch_up(void);

// ---- Programs and kernels -----------------------------------------------------------------------

enum { MAX_PARAMETERS = 32, MAX_PARAMETER_BYTES = 256 };

// What compile.c writes of a parameter: its size, and above it its kind.
enum { PARAMETER_VALUE = 0, PARAMETER_BUFFER = 1, PARAMETER_IMAGE = 2, PARAMETER_KIND_BIT = 16 };

struct _cl_kernel {
    void (*entry)(void *const *arguments);
    const cl_uint *parameters;  // how many, then each one's size and kind
    const cl_uint *elements;    // of a buffer, the size of what it is an array of; else 0
    const char *names;          // of the parameters, each with a '\0' behind it
    cl_uint is_set[MAX_PARAMETERS];
    _Alignas(16) char values[MAX_PARAMETERS][MAX_PARAMETER_BYTES];
};

// The kernel that runs, or NULL.
extern cl_kernel kernel_running;

// What a work-item may ask for: the numbers are those of builtins.cl.
enum { ASKS_GLOBAL_ID, ASKS_LOCAL_ID, ASKS_GROUP_ID, ASKS_GLOBAL_SIZE, ASKS_LOCAL_SIZE, N_ASKED };
size_t native_item(cl_uint what, cl_uint dimension);

#endif
