// The workshop: a temporary folder with everything a sandbox gets to see, and in it the variants of
// a submission (variant.h).
//
//     tree/               seen as /work: headers, kernels, probes, libraries, earlier solutions
//     job/job             what the probe shall try
//     NAME/lab            a variant's files, seen as /work/labs/NN-name
//     NAME/job            what its probe shall try, where that is another
//     NAME/build, out     what its compiler and its probe write
#ifndef GRADER_WORKSHOP_H
#define GRADER_WORKSHOP_H

#include "manifest.h"
#include "sandbox.h"

#include <limits.h>

typedef struct Workshop {
    char folder[PATH_MAX];  // under $TMPDIR or /tmp
    const char *build;      // the build folder with the probes and libraries, "build"
    const Manifest *manifest;
    const char *device;  // value of COURSE_DEVICE inside; "" for the first
    SandboxKind sandbox;
    int needs_compiler;  // the lab has host files
} Workshop;

// Make the folder and copy in what the lab needs. Returns 0, or -1 after one message on stderr.
int workshop_open(Workshop *workshop, const Manifest *manifest, const char *build,
                  const char *device, SandboxKind sandbox);

// Remove the folder.
void workshop_close(Workshop *workshop);

// Where the job is to be written before any variant runs.
void workshop_job_path(const Workshop *workshop, char path[PATH_MAX]);

#endif
