// A queue that is held up until the student's read_back() waits for it, or has returned: so a read
// that nobody waits for arrives too late, on every machine, however long the function takes.
//
// The functions below stand before the driver's of the same name. They are those of OpenCL 1.2 that
// move pixels or wait, so that no right way to read back is held up for ever.
#ifndef PROBES_HELD_QUEUE_H
#define PROBES_HELD_QUEUE_H

#include "cl_check.h"
#include "probe.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

// Who asks so often whether a command is done waits for it.
enum { POLLS_OF_A_WAIT = 100 };

static struct {
    int is_watched;    // from queue_hold() to queue_release()
    cl_event release;  // all commands behind it wait for this; NULL where none is held up
    int n_polls;
} held;

// Let what is held up go on.
static void held_go_on(void)
{
    cl_event release = held.release;
    held.release = NULL;
    held.n_polls = 0;
    if (release != NULL) {
        CL_CHECK(clSetUserEventStatus(release, CL_COMPLETE));
        CL_CHECK(clReleaseEvent(release));
    }
}

static void held_hold(cl_command_queue queue)
{
    cl_int error;
    cl_context context;
    CL_CHECK(clGetCommandQueueInfo(queue, CL_QUEUE_CONTEXT, sizeof context, &context, NULL));
    held.release = clCreateUserEvent(context, &error);
    CL_CHECK_CREATED(error, clCreateUserEvent);
    CL_CHECK(clEnqueueBarrierWithWaitList(queue, 1, &held.release, NULL));
}

// Hold up all that is queued from now on, until somebody waits.
static void queue_hold(cl_command_queue queue)
{
    static int is_prepared;
    if (!is_prepared && atexit(held_go_on) != 0) {
        exit(PROBE_EXIT_FAULT);
    }
    is_prepared = 1;
    held.is_watched = 1;
    held_hold(queue);
}

static void queue_release(void)
{
    held.is_watched = 0;
    held_go_on();
}

// ---- What the student's function calls ------------------------------------------------------

// One that waits for what it moves ends the hold. One that does not is held up, also where an
// earlier call waited.
static void held_see_move(cl_command_queue queue, cl_bool is_blocking)
{
    if (is_blocking) {
        held_go_on();
    } else if (held.is_watched && held.release == NULL) {
        held_hold(queue);
    }
}

// Is one of these events still to come? What is held up is.
static int held_is_to_come(cl_uint n_events, const cl_event *events)
{
    int is_to_come = events == NULL;
    for (cl_uint i = 0; i < n_events && !is_to_come; i++) {
        cl_int status = CL_COMPLETE;
        clGetEventInfo(events[i], CL_EVENT_COMMAND_EXECUTION_STATUS, sizeof status, &status, NULL);
        is_to_come = status > CL_COMPLETE;
    }
    return is_to_come;
}

static void held_see_wait(cl_uint n_events, const cl_event *events)
{
    if (held.release != NULL && held_is_to_come(n_events, events)) {
        held_go_on();
    }
}

static void held_see_poll(void)
{
    if (held.release != NULL && ++held.n_polls >= POLLS_OF_A_WAIT) {
        held_go_on();
    }
}

// POSIX has dlsym() return functions as void *; C11 has no cast for that.
#define STANDS_BEFORE(TYPE, NAME, PARAMETERS, ARGUMENTS, NOTE)                                     \
    TYPE NAME PARAMETERS                                                                           \
    {                                                                                              \
        TYPE(*driver) PARAMETERS;                                                                  \
        void *const symbol = dlsym(RTLD_NEXT, #NAME);                                              \
        memcpy(&driver, &symbol, sizeof driver);                                                   \
        NOTE;                                                                                      \
        return driver ARGUMENTS;                                                                   \
    }

STANDS_BEFORE(cl_int, clEnqueueReadImage,
              (cl_command_queue queue, cl_mem image, cl_bool is_blocking, const size_t *origin,
               const size_t *region, size_t row_pitch, size_t slice_pitch, void *pixels,
               cl_uint n_events, const cl_event *events, cl_event *done),
              (queue, image, is_blocking, origin, region, row_pitch, slice_pitch, pixels, n_events,
               events, done),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(cl_int, clEnqueueWriteImage,
              (cl_command_queue queue, cl_mem image, cl_bool is_blocking, const size_t *origin,
               const size_t *region, size_t row_pitch, size_t slice_pitch, const void *pixels,
               cl_uint n_events, const cl_event *events, cl_event *done),
              (queue, image, is_blocking, origin, region, row_pitch, slice_pitch, pixels, n_events,
               events, done),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(void *, clEnqueueMapImage,
              (cl_command_queue queue, cl_mem image, cl_bool is_blocking, cl_map_flags flags,
               const size_t *origin, const size_t *region, size_t *row_pitch, size_t *slice_pitch,
               cl_uint n_events, const cl_event *events, cl_event *done, cl_int *error),
              (queue, image, is_blocking, flags, origin, region, row_pitch, slice_pitch, n_events,
               events, done, error),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(cl_int, clEnqueueReadBuffer,
              (cl_command_queue queue, cl_mem buffer, cl_bool is_blocking, size_t offset,
               size_t n_bytes, void *bytes, cl_uint n_events, const cl_event *events,
               cl_event *done),
              (queue, buffer, is_blocking, offset, n_bytes, bytes, n_events, events, done),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(cl_int, clEnqueueWriteBuffer,
              (cl_command_queue queue, cl_mem buffer, cl_bool is_blocking, size_t offset,
               size_t n_bytes, const void *bytes, cl_uint n_events, const cl_event *events,
               cl_event *done),
              (queue, buffer, is_blocking, offset, n_bytes, bytes, n_events, events, done),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(cl_int, clEnqueueReadBufferRect,
              (cl_command_queue queue, cl_mem buffer, cl_bool is_blocking, const size_t *offset,
               const size_t *h_offset, const size_t *region, size_t row_pitch, size_t slice_pitch,
               size_t h_row_pitch, size_t h_slice_pitch, void *bytes, cl_uint n_events,
               const cl_event *events, cl_event *done),
              (queue, buffer, is_blocking, offset, h_offset, region, row_pitch, slice_pitch,
               h_row_pitch, h_slice_pitch, bytes, n_events, events, done),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(cl_int, clEnqueueWriteBufferRect,
              (cl_command_queue queue, cl_mem buffer, cl_bool is_blocking, const size_t *offset,
               const size_t *h_offset, const size_t *region, size_t row_pitch, size_t slice_pitch,
               size_t h_row_pitch, size_t h_slice_pitch, const void *bytes, cl_uint n_events,
               const cl_event *events, cl_event *done),
              (queue, buffer, is_blocking, offset, h_offset, region, row_pitch, slice_pitch,
               h_row_pitch, h_slice_pitch, bytes, n_events, events, done),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(void *, clEnqueueMapBuffer,
              (cl_command_queue queue, cl_mem buffer, cl_bool is_blocking, cl_map_flags flags,
               size_t offset, size_t n_bytes, cl_uint n_events, const cl_event *events,
               cl_event *done, cl_int *error),
              (queue, buffer, is_blocking, flags, offset, n_bytes, n_events, events, done, error),
              held_see_move(queue, is_blocking))

STANDS_BEFORE(cl_int, clFinish, (cl_command_queue queue), (queue), held_see_wait(0, NULL))

STANDS_BEFORE(cl_int, clWaitForEvents, (cl_uint n_events, const cl_event *events),
              (n_events, events), held_see_wait(n_events, events))

STANDS_BEFORE(cl_int, clGetEventInfo,
              (cl_event event, cl_event_info name, size_t n_bytes, void *value, size_t *n_used),
              (event, name, n_bytes, value, n_used), held_see_poll())

// Whoever is called back waits in a way of its own.
STANDS_BEFORE(cl_int, clSetEventCallback,
              (cl_event event, cl_int status, void(CL_CALLBACK *call)(cl_event, cl_int, void *),
               void *with),
              (event, status, call, with), held_go_on())

#endif
