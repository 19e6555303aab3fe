// Reading the work counters back (see work_stats.h); what they count stands in kernels/work.h.
//
// A buffer beside the picture, for the figures. Read next: stats.c.
#include "work_stats.h"

#include "complain.h"
#include "image.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Work-items that fill up the last work-groups write nothing; should a student's do, it stays
// inside.
enum { GROUP_MARGIN = 64 };

// The counters of a Work. The first is called after what is tested.
static const struct Counter {
    const char *name;
    size_t offset;
} COUNTERS[] = {
    {NULL, offsetof(Work, n_tests)},
    {"nodes_visited", offsetof(Work, n_nodes_visited)},
    {"leaves_visited", offsetof(Work, n_leaves_visited)},
    {"stack_depth", offsetof(Work, stack_depth)},
};
enum { N_CIRCLE_COUNTERS = 2, N_SPHERE_COUNTERS = 4 };

// What differs from kind to kind.
static const struct Kind {
    const char *test_name;
    int n_counters;
    const char *prefix;  // of the figures
    const char *ending;  // of the pictures, before "-work.png"
} KINDS[] = {
    [WORK_CIRCLES] = {"circle_tests", N_CIRCLE_COUNTERS, "", ""},
    [WORK_SPHERES] = {"sphere_tests", N_SPHERE_COUNTERS, "", ""},
    [WORK_SPHERES_MIDDLE] = {"sphere_tests", N_SPHERE_COUNTERS, "middle.", "-middle"},
};

_Static_assert(N_SPHERE_COUNTERS == IMAGE_CHANNELS && sizeof(Work) == 4 * sizeof(u32),
               "a pixel has a channel for each counter");

static Work *work_allocate(size_t n_pixels)
{
    Work *h_work = calloc(n_pixels, sizeof *h_work);
    if (h_work == NULL) {
        complain("work_stats: no memory for the counters of %zu pixels", n_pixels);
        exit(EXIT_FAILURE);
    }
    return h_work;
}

cl_mem work_buffer_create(const ClSetup *cl, int width, int height)
{
    const size_t n_pixels = ((size_t)width + GROUP_MARGIN) * ((size_t)height + GROUP_MARGIN);
    Work *h_zeros = work_allocate(n_pixels);
    cl_int error;
    cl_mem d_work = clCreateBuffer(cl->context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                                   n_pixels * sizeof *h_zeros, h_zeros, &error);
    CL_CHECK_CREATED(error, clCreateBuffer);
    free(h_zeros);
    return d_work;
}

static u32 counter_of(const Work *work, const struct Counter *counter)
{
    u32 count;
    memcpy(&count, (const char *)work + counter->offset, sizeof count);
    return count;
}

static void add_figures(const Work *h_work, size_t n_pixels, const struct Kind *kind, Stats *stats)
{
    for (int c = 0; c < kind->n_counters; c++) {
        const char *counter_name = COUNTERS[c].name != NULL ? COUNTERS[c].name : kind->test_name;
        double sum = 0;
        u32 most = 0;
        for (size_t i = 0; i < n_pixels; i++) {
            const u32 count = counter_of(&h_work[i], &COUNTERS[c]);
            sum += count;
            most = count > most ? count : most;
        }
        char name[64];
        snprintf(name, sizeof name, "%s%s.mean_per_pixel", kind->prefix, counter_name);
        stats_number(stats, name, sum / (double)n_pixels);
        snprintf(name, sizeof name, "%s%s.max_per_pixel", kind->prefix, counter_name);
        stats_integer(stats, name, most);
    }
}

// Save a picture as the path of the run's picture with another ending: "a.png" becomes
// "a-work.exr".
static int save_beside(const Image *image, const char *picture_path, const struct Kind *kind,
                       const char *ending)
{
    char *path;
    if (asprintf(&path, "%.*s%s%s", (int)image_stem_length(picture_path), picture_path,
                 kind->ending, ending) < 0) {
        complain("%s: no memory", picture_path);
        return -1;
    }
    const int result = image_save(image, path);
    free(path);
    return result;
}

u32 work_steps(const Work *work)
{
    return work->n_tests + work->n_nodes_visited + work->n_leaves_visited;
}

static int save_pictures(const Work *h_work, Image *image, const char *picture_path,
                         const struct Kind *kind, Stats *stats)
{
    const size_t n_pixels = (size_t)image->width * (size_t)image->height;
    u32 brightest = 1;
    for (size_t i = 0; i < n_pixels; i++) {
        for (int c = 0; c < IMAGE_CHANNELS; c++) {
            image->pixels[i * IMAGE_CHANNELS + (size_t)c] =
                (float)counter_of(&h_work[i], &COUNTERS[c]);
        }
        brightest = work_steps(&h_work[i]) > brightest ? work_steps(&h_work[i]) : brightest;
    }
    if (save_beside(image, picture_path, kind, "-work.exr") != 0) {
        return -1;
    }
    for (size_t i = 0; i < n_pixels; i++) {
        float *pixel = image->pixels + i * IMAGE_CHANNELS;
        image_heat_colour((float)work_steps(&h_work[i]) / (float)brightest, pixel);
        pixel[3] = 1;
    }
    char name[64];
    snprintf(name, sizeof name, "%sheat_map.brightest", kind->prefix);
    stats_integer(stats, name, brightest);
    return save_beside(image, picture_path, kind, "-work.png");
}

int work_report(const ClSetup *cl, cl_mem d_work, int width, int height, WorkKind kind,
                const char *picture_path, Stats *stats)
{
    const size_t n_pixels = (size_t)width * (size_t)height;
    Work *h_work = work_allocate(n_pixels);
    CL_CHECK(clEnqueueReadBuffer(cl->queue, d_work, CL_TRUE, 0, n_pixels * sizeof *h_work, h_work,
                                 0, NULL, NULL));
    add_figures(h_work, n_pixels, &KINDS[kind], stats);
    int result = 0;
    if (picture_path != NULL) {
        Image image = {0};
        result = image_create(width, height, &image);
        if (result == 0) {
            result = save_pictures(h_work, &image, picture_path, &KINDS[kind], stats);
        }
        image_free(&image);
    }
    free(h_work);
    return result;
}
