// What all probes share: the job, the answers, the device, and drawing into an image with a margin.
#ifndef PROBES_PROBE_H
#define PROBES_PROBE_H

#include "cl_setup.h"
#include "jobs.h"
#include "note.h"
#include "sections.h"
#include "tree3d.h"

#include <stdio.h>

// Where the sandbox has the job and takes the answers, from the folder the probe starts in. Behind
// them stands what this variable says, ".3" for the jobs of further seeds; nothing for the first.
#define PROBE_JOB_PATH "job/job"
#define PROBE_ANSWERS_PATH "out/answers"
#define PROBE_JOB_VARIABLE "COURSE_JOB"

// Set where nobody asks for what the tasks of host files are answered.
#define PROBE_KERNELS_VARIABLE "COURSE_KERNELS"

// The first section of the answers of a lab with kernels: what they run on.
#define PROBE_DEVICE "device"

// The last section of complete answers: a student's exit(0) leaves none.
#define PROBE_END "end"

// Exit statuses of a probe besides EXIT_SUCCESS: what the grader makes of them is in variant_end.c.
enum {
    PROBE_EXIT_NO_BUILD = 10,  // the kernel did not compile; the log is on stderr
    PROBE_EXIT_FAULT = 11,     // job or device missing: the machinery's fault
};

typedef struct Probe {
    Sections job;
    FILE *answers;
    ProbeNote *note;  // shared with its file: what is written stays, however this ends
    ClSetup cl;       // when opened
} Probe;

// Load the job and open the answers; ends the program with PROBE_EXIT_FAULT when it cannot.
void probe_open(Probe *probe);

// Open the device named by $COURSE_DEVICE and write its name as section "device".
void probe_open_device(Probe *probe);

// Write the section PROBE_END and release everything.
void probe_close(Probe *probe);

// Open all of it for a lab with kernels, and build the program in the lab's probe.cl; close it.
#define PROBE_PROGRAM "probes/" LAB_NAME "/probe.cl"
#define PROBE_COUNTING PROBE_KERNEL_OPTIONS " -I " LAB_FOLDER " -I probes -DCOUNT_WORK"
cl_program probe_open_program(Probe *probe, const char *path, const char *options);
void probe_close_program(Probe *probe, cl_program program);

// Does the job ask for this?
int probe_asks(const Probe *probe, const char *name);

// Is this the task whose answer is tried alone? Not where all of a submission is.
int probe_alone(const Probe *probe, const char *task);

// The section called name, or the end of the program with PROBE_EXIT_FAULT.
const void *probe_job(const Probe *probe, const char *name, size_t *n_bytes);

// Scene number k, or NULL when the job has no more.
const SceneJob *probe_scene(const Probe *probe, int k);

// A part of scene k: probe_scene_part(probe, 3, "circles", &n) gives "scene.3.circles".
const void *probe_scene_part(const Probe *probe, int k, const char *part, size_t *n_bytes);

// Note what is called next, so that the report can say where a crash was.
//   name    of the job's section with the inputs, or what is answered for scenes: the judge's
//           JobPart or SceneStep (judge.h)
//   input   its number among the section's, the scene's, or PROBE_NO_INPUT
void probe_note(const Probe *probe, const char *name, uint32_t input);

// Write a section "name.K" or, with a part, "name.K.part".
void probe_answer(const Probe *probe, const char *name, int k, const char *part, const void *bytes,
                  size_t n_bytes);

// Write an array as section "name" and free it.
void probe_answer_array(const Probe *probe, const char *name, void *array, size_t n_bytes);

// A function of the student's on the host, and the section of the job with its inputs.
typedef struct ProbeFunction {
    const char *section;
    // Call it with one input; the answers, all zeros before, become a section of the same name.
    size_t input_bytes, answer_bytes;
    void (*call)(const Probe *probe, const void *input, void *answer);
    // Where that is not enough, in its place: answer the section as a whole.
    void (*answer)(const Probe *probe, const char *section);
} ProbeFunction;

// Call the functions that the job asks for, one by one (probe_host.c).
void probe_call_host(const Probe *probe, const ProbeFunction *functions, size_t n);

// Make n entries UNTOUCHED.
void probe_leave_untouched(uint32_t *array, size_t n);

// Pack all leaves of scene K, the first of which is leaves[0], into a tree.
typedef void PackTree(const Probe *probe, uint32_t k, ReplayTree room, const ReplayList *leaves,
                      size_t n_leaves);

// Do so for every scene of a replay (jobs.h, "Replays"), whose leaves are section "name".
void probe_replay_leaves(const Probe *probe, const char *name, PackTree *pack_tree);

// kdtree3d_build() of lab 06, or what takes its place.
typedef int BuildTree3D(const Sphere *h_spheres, u32 n_spheres, KdTreeLimits limits,
                        KdTree3D *tree);

// Build a tree for every scene of the job, and answer as jobs.h says of lab 06.
void probe_answer_trees(const Probe *probe, BuildTree3D *build);

// Build the program; ends with PROBE_EXIT_NO_BUILD when it does not compile.
cl_program probe_build(const Probe *probe, const char *path, const char *options);

// A kernel of the program; ends with PROBE_EXIT_NO_BUILD when there is none of that name. Of the
// student's kernels: before any other is run, as the grader believes that status only there.
cl_kernel probe_kernel(cl_program program, const char *name);

// A section of the job, or a part of scene k, on the device, where kernels only read it.
cl_mem probe_section_create(const Probe *probe, const char *name);
cl_mem probe_part_create(const Probe *probe, int k, const char *part);

// Room for answers on the device, every bit set. Release with probe_answer_buffer().
cl_mem probe_buffer(const Probe *probe, size_t n_bytes);

// Read a buffer, write it as section "name", or "name.K" where k is not negative, and release it.
void probe_answer_buffer(const Probe *probe, const char *name, int k, cl_mem d_answers,
                         size_t n_bytes);

// Call a function of the student's on the device, one work-item an input: kernel "probe_NAME" takes
// the job's section "NAME", some buffers, and an array for the answers, which become section
// "NAME". Nothing where the job does not ask for it.
//   job_bytes, answer_bytes   of one input and of one answer
//   d_buffers[n_buffers]      or NULL, 0
void probe_call(const Probe *probe, cl_program program, const char *name, size_t job_bytes,
                size_t answer_bytes, const cl_mem *d_buffers, cl_uint n_buffers);

// The same where the buffers are sections of the job.
//   buffers[n_buffers]   their names
void probe_call_with(const Probe *probe, cl_program program, const char *name, size_t job_bytes,
                     size_t answer_bytes, const char *const *buffers, cl_uint n_buffers);

// The image for a picture of this size with its margin, every pixel UNWRITTEN.
cl_mem probe_image(const Probe *probe, int width, int height);

// Launch over the whole image, margin included.
void probe_launch(const Probe *probe, cl_kernel kernel, int width, int height);

// Launch in one dimension, a work-item for each pixel of the picture, row by row, wait, and answer
// with "picture.K".
void probe_draw_rows(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width,
                     int height);

// Launch over the whole image, margin included, wait, and answer with "picture.K".
void probe_draw(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width, int height);

// The same counting: argument number `argument` of the kernel is the Work array, which is answered
// with "work.K"; there is room in it for the work-items outside the picture, should they not leave.
void probe_draw_counting(const Probe *probe, int k, cl_kernel kernel, cl_mem d_image, int width,
                         int height, cl_uint argument);

// Where an image's pixels may be read from its corner on, row by row in steps of *n_row_bytes,
// until it is unmapped. Students read images back by clEnqueueReadImage: this is no answer to copy.
const void *probe_map_image(const Probe *probe, cl_mem d_image, const size_t region[3],
                            size_t *n_row_bytes);
void probe_unmap_image(const Probe *probe, cl_mem d_image, const void *mapped);

// Read the whole image and answer with "picture.K".
void probe_answer_image(const Probe *probe, int k, cl_mem d_image, int width, int height);

// ---- 3D -----------------------------------------------------------------------------------------

// 3D scene number k, or NULL when the job has no more.
const SceneJob3D *probe_scene3d(const Probe *probe, int k);

// A 3D scene on the device, with what a kernel that draws spheres takes first: see scene_buffers.h
// of lab 05.
enum { N_SCENE3D_ARRAYS = 4, N_SCENE3D_ARGUMENTS = 10 };
typedef struct Scene3DBuffers {
    cl_mem d_arrays[N_SCENE3D_ARRAYS];  // spheres, material_ids, materials, lights
    cl_mem d_image;
} Scene3DBuffers;

Scene3DBuffers probe_scene3d_buffers(const Probe *probe, int k, const SceneJob3D *scene);
void probe_scene3d_release(Scene3DBuffers *buffers);

// Set the kernel's first N_SCENE3D_ARGUMENTS arguments.
void probe_scene3d_set(const Scene3DBuffers *buffers, const SceneJob3D *scene, cl_kernel kernel);

#endif
