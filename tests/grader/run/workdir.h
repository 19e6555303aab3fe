// The workdir: a temporary folder with everything a sandbox gets to see, and in it the variants of
// a submission (variant.h).
//
//     tree/               seen as /work: headers, kernels, probes, libraries, earlier solutions
//     job/job             what the probe shall try
//     job/job.1, ...      the same drawn from further seeds, where there are any
//     NAME/lab            a variant's files, seen as /work/labs/NN-name
//     NAME/job            what its probe shall try, where that is another
//     NAME/build, out     what its compiler and its probe write
#ifndef GRADER_WORKDIR_H
#define GRADER_WORKDIR_H

#include "janitor.h"
#include "manifest.h"
#include "sandbox.h"

#include <limits.h>

typedef struct Workdir {
    char folder[PATH_MAX];  // under $TMPDIR or /tmp
    char tree[PATH_MAX];    // in it: seen as /work
    const char *build;      // the build folder with the probes and libraries, "build"
    const Manifest *manifest;
    const char *device;  // value of COURSE_DEVICE inside; "" for the first
    SandboxKind sandbox;
    int needs_compiler;  // the lab has host files
    int n_further_jobs;  // tried by each variant but those alone
    Janitor janitor;     // clears up where the grader cannot
} Workdir;

// The most jobs besides the first.
enum { MAX_FURTHER_JOBS = 31 };

// Make the folder and copy in what the lab needs. Returns 0, or -1 after one message on stderr.
int workdir_open(Workdir *workdir, const Manifest *manifest, const char *build, const char *device,
                 SandboxKind sandbox);

// A command in its sandbox, which sees its tree and has the limits of run_end.h. The strings must
// stay until it is started.
SandboxCommand workdir_command(const Workdir *workdir, const char *const *argv,
                               const char *const *environment, SandboxTime time);

// Remove the folder.
void workdir_close(Workdir *workdir);

// Where job number `job` is to be written before any variant runs: 0, or of a further seed.
void workdir_job_path(const Workdir *workdir, int job, char path[PATH_MAX]);

// What stands behind the names of its files: "" for 0, ".3" for the third further one.
void workdir_job_suffix(int job, char suffix[16]);

#endif
