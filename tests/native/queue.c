// The device, its context and its queue (see native_cl.h).
//
// A user event holds the queue up, as lab 00's probe does: what does not wait is then kept until
// the event's thread lets it go. Read next: memory.c.
#include "native_cl.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

struct _cl_platform_id {
    const char *name;
};
struct _cl_device_id {
    const char *name;
    size_t largest_side;
};
struct _cl_context {
    cl_device_id device;
};
struct _cl_command_queue {
    cl_context context;
    cl_event held_by;  // NULL: by nothing
    Copy *kept;
    size_t n_kept;
};

static struct _cl_platform_id the_platform = {"Native"};
static struct _cl_device_id the_device = {"this processor, by clang", 8192};
static struct _cl_context the_context = {&the_device};
static struct _cl_command_queue the_queue = {.context = &the_context};

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t has_changed = PTHREAD_COND_INITIALIZER;

// ---- Who is asked -------------------------------------------------------------------------------

// Answer a question about an object. Returns CL_SUCCESS, or CL_INVALID_VALUE without room.
static cl_int answer(const void *value, size_t n_bytes, size_t n_room, void *to, size_t *n_answered)
{
    if (to != NULL) {
        if (n_room < n_bytes) {
            return CL_INVALID_VALUE;
        }
        memcpy(to, value, n_bytes);
    }
    if (n_answered != NULL) {
        *n_answered = n_bytes;
    }
    return CL_SUCCESS;
}

static cl_int answer_text(const char *text, size_t n_room, void *to, size_t *n_answered)
{
    return answer(text, strlen(text) + 1, n_room, to, n_answered);
}

cl_int clGetPlatformIDs(cl_uint n_room, cl_platform_id *platforms, cl_uint *n_platforms)
{
    if (platforms != NULL && n_room > 0) {
        platforms[0] = &the_platform;
    }
    if (n_platforms != NULL) {
        *n_platforms = 1;
    }
    return CL_SUCCESS;
}

cl_int clGetPlatformInfo(cl_platform_id platform, cl_platform_info question, size_t n_room,
                         void *to, size_t *n_answered)
{
    return question == CL_PLATFORM_NAME ? answer_text(platform->name, n_room, to, n_answered)
                                        : CL_INVALID_VALUE;
}

cl_int clGetDeviceIDs(cl_platform_id platform, cl_device_type type, cl_uint n_room,
                      cl_device_id *devices, cl_uint *n_devices)
{
    (void)platform, (void)type;
    if (devices != NULL && n_room > 0) {
        devices[0] = &the_device;
    }
    if (n_devices != NULL) {
        *n_devices = 1;
    }
    return CL_SUCCESS;
}

cl_int clGetDeviceInfo(cl_device_id device, cl_device_info question, size_t n_room, void *to,
                       size_t *n_answered)
{
    const cl_bool has_images = CL_TRUE;
    switch (question) {
    case CL_DEVICE_NAME:
        return answer_text(device->name, n_room, to, n_answered);
    case CL_DEVICE_IMAGE_SUPPORT:
        return answer(&has_images, sizeof has_images, n_room, to, n_answered);
    case CL_DEVICE_IMAGE2D_MAX_WIDTH:
    case CL_DEVICE_IMAGE2D_MAX_HEIGHT:
        return answer(&device->largest_side, sizeof device->largest_side, n_room, to, n_answered);
    default:
        return CL_INVALID_VALUE;
    }
}

cl_context clCreateContext(const cl_context_properties *properties, cl_uint n_devices,
                           const cl_device_id *devices,
                           void (*notify)(const char *, const void *, size_t, void *), void *data,
                           cl_int *error)
{
    (void)properties, (void)n_devices, (void)devices, (void)notify, (void)data;
    *error = CL_SUCCESS;
    return &the_context;
}

cl_int clReleaseContext(cl_context context)
{
    return context == &the_context ? CL_SUCCESS : CL_INVALID_CONTEXT;
}

cl_command_queue clCreateCommandQueue(cl_context context, cl_device_id device,
                                      cl_command_queue_properties properties, cl_int *error)
{
    (void)context, (void)device, (void)properties;
    *error = CL_SUCCESS;
    return &the_queue;
}

cl_int clReleaseCommandQueue(cl_command_queue queue)
{
    return queue == &the_queue ? CL_SUCCESS : CL_INVALID_COMMAND_QUEUE;
}

cl_int clGetCommandQueueInfo(cl_command_queue queue, cl_command_queue_info question, size_t n_room,
                             void *to, size_t *n_answered)
{
    return question == CL_QUEUE_CONTEXT
               ? answer(&queue->context, sizeof queue->context, n_room, to, n_answered)
               : CL_INVALID_VALUE;
}

// ---- Copies, at once or later -------------------------------------------------------------------

static void copy_run(const Copy *copy)
{
    for (size_t row = 0; row < copy->n_rows; row++) {
        char *to = (char *)copy->to + row * copy->to_pitch;
        memcpy(to, (const char *)copy->from + row * copy->from_pitch, copy->n_row_bytes);
        memory_was_set(to, copy->n_row_bytes);
    }
    if (copy->done != NULL) {
        copy->done->status = CL_COMPLETE;
    }
}

static cl_event event_new(cl_int status)
{
    cl_event event = calloc(1, sizeof *event);
    if (event != NULL) {
        event->status = status;
    }
    return event;
}

// Keep a copy for later. Returns CL_SUCCESS, or an error.
static cl_int keep(const Copy *copy)
{
    Copy *kept = realloc(the_queue.kept, (the_queue.n_kept + 1) * sizeof *kept);
    if (kept == NULL) {
        return CL_OUT_OF_HOST_MEMORY;
    }
    the_queue.kept = kept;
    the_queue.kept[the_queue.n_kept++] = *copy;
    return CL_SUCCESS;
}

cl_int queue_copy(Copy copy, cl_bool is_blocking, cl_event *done)
{
    cl_int result = CL_SUCCESS;
    if (done != NULL) {
        copy.done = *done = event_new(CL_QUEUED);
    }
    if (is_blocking) {
        queue_catch_up();
    }
    pthread_mutex_lock(&lock);
    if (the_queue.held_by != NULL) {
        result = keep(&copy);
    } else {
        copy_run(&copy);
    }
    pthread_mutex_unlock(&lock);
    return result;
}

void queue_catch_up(void)
{
    pthread_mutex_lock(&lock);
    while (the_queue.held_by != NULL) {
        pthread_cond_wait(&has_changed, &lock);
    }
    pthread_mutex_unlock(&lock);
}

cl_int clFinish(cl_command_queue queue)
{
    if (queue != &the_queue) {
        return CL_INVALID_COMMAND_QUEUE;
    }
    queue_catch_up();
    return CL_SUCCESS;
}

// ---- Events -------------------------------------------------------------------------------------

cl_event clCreateUserEvent(cl_context context, cl_int *error)
{
    (void)context;
    cl_event event = event_new(CL_SUBMITTED);
    *error = event != NULL ? CL_SUCCESS : CL_OUT_OF_HOST_MEMORY;
    return event;
}

cl_int clEnqueueBarrierWithWaitList(cl_command_queue queue, cl_uint n_events,
                                    const cl_event *events, cl_event *done)
{
    (void)done;
    pthread_mutex_lock(&lock);
    for (cl_uint i = 0; i < n_events; i++) {
        if (events[i]->status != CL_COMPLETE) {
            queue->held_by = events[i];
        }
    }
    pthread_mutex_unlock(&lock);
    return CL_SUCCESS;
}

// Comes when its turn is: a copy of nothing.
cl_int clEnqueueMarkerWithWaitList(cl_command_queue queue, cl_uint n_events, const cl_event *events,
                                   cl_event *done)
{
    (void)events;
    return queue == &the_queue && n_events == 0 ? queue_copy((Copy){0}, CL_FALSE, done)
                                                : CL_INVALID_VALUE;
}

cl_int clSetUserEventStatus(cl_event event, cl_int status)
{
    pthread_mutex_lock(&lock);
    event->status = status;
    if (the_queue.held_by == event) {
        for (size_t i = 0; i < the_queue.n_kept; i++) {
            copy_run(&the_queue.kept[i]);
        }
        the_queue.n_kept = 0;
        the_queue.held_by = NULL;
    }
    pthread_cond_broadcast(&has_changed);
    pthread_mutex_unlock(&lock);
    return CL_SUCCESS;
}

cl_int clWaitForEvents(cl_uint n_events, const cl_event *events)
{
    pthread_mutex_lock(&lock);
    for (cl_uint i = 0; i < n_events; i++) {
        while (events[i]->status != CL_COMPLETE) {
            pthread_cond_wait(&has_changed, &lock);
        }
    }
    pthread_mutex_unlock(&lock);
    return CL_SUCCESS;
}

cl_int clGetEventInfo(cl_event event, cl_event_info question, size_t n_room, void *to,
                      size_t *n_answered)
{
    if (question != CL_EVENT_COMMAND_EXECUTION_STATUS) {
        return CL_INVALID_VALUE;
    }
    pthread_mutex_lock(&lock);
    const cl_int status = event->status;
    pthread_mutex_unlock(&lock);
    return answer(&status, sizeof status, n_room, to, n_answered);
}

// Nobody has it any more: a copy that is still to come has nobody to tell.
cl_int clReleaseEvent(cl_event event)
{
    pthread_mutex_lock(&lock);
    for (size_t i = 0; i < the_queue.n_kept; i++) {
        if (the_queue.kept[i].done == event) {
            the_queue.kept[i].done = NULL;
        }
    }
    pthread_mutex_unlock(&lock);
    free(event);
    return CL_SUCCESS;
}
