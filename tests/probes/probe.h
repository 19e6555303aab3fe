// What all probes share: the job, the answers, the device, and drawing into an image with a margin.
#ifndef PROBES_PROBE_H
#define PROBES_PROBE_H

#include "cl_setup.h"
#include "jobs.h"
#include "sections.h"

#include <stdio.h>

// Where the sandbox has the job and takes the answers, from the folder the probe starts in.
#define PROBE_JOB_PATH "job/job"
#define PROBE_ANSWERS_PATH "out/answers"

// The last section of complete answers: a student's exit(0) leaves none.
#define PROBE_END "end"

// Exit statuses of a probe besides EXIT_SUCCESS: what the grader makes of them is in workshop.c.
enum {
    PROBE_EXIT_NO_BUILD = 10,  // the kernel did not compile; the log is on stderr
    PROBE_EXIT_FAULT = 11,     // job or device missing: the machinery's fault
};

typedef struct Probe {
    Sections job;
    FILE *answers;
    ClSetup cl;  // when opened
} Probe;

// Load the job and open the answers; ends the program with PROBE_EXIT_FAULT when it cannot.
void probe_open(Probe *probe);

// Open the device named by $COURSE_DEVICE and write its name as section "device".
void probe_open_device(Probe *probe);

// Write the section PROBE_END and release everything.
void probe_close(Probe *probe);

// The section called name, or the end of the program with PROBE_EXIT_FAULT.
const void *probe_job(const Probe *probe, const char *name, size_t *n_bytes);

// Scene number k, or NULL when the job has no more.
const SceneJob *probe_scene(const Probe *probe, int k);

// A part of scene k: probe_scene_part(probe, 3, "circles", &n) gives "scene.3.circles".
const void *probe_scene_part(const Probe *probe, int k, const char *part, size_t *n_bytes);

// Write a section "name.K" or, with a part, "name.K.part".
void probe_answer(const Probe *probe, const char *name, int k, const char *part, const void *bytes,
                  size_t n_bytes);

// Build the program; ends with PROBE_EXIT_NO_BUILD when it does not compile.
cl_program probe_build(const Probe *probe, const char *path, const char *options);

// A kernel of the program; ends with PROBE_EXIT_NO_BUILD when there is none of that name.
cl_kernel probe_kernel(cl_program program, const char *name);

// The image for a picture of this size with its margin, every pixel UNWRITTEN.
cl_mem probe_image(const Probe *probe, int width, int height);

// Launch over the whole image, margin included, wait, and answer with "picture.K".
void probe_draw(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width, int height);

// Read the whole image and answer with "picture.K".
void probe_answer_image(const Probe *probe, int k, cl_mem d_image, int width, int height);

#endif
