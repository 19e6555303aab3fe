// The process that starts one sandboxed command, holds it to its limits and outlives all of it.
#ifndef GRADER_SANDBOX_SUPERVISOR_H
#define GRADER_SANDBOX_SUPERVISOR_H

#include "sandbox.h"

#include <sys/types.h>

// The unprivileged user and group that a grader run by root uses: nobody and nogroup.
#define SANDBOX_NOBODY 65534

// What it found out, in memory shared with the grader.
typedef struct SandboxReport {
    int is_complete;  // set last: the supervisor itself came to its end
    SandboxOutcome outcome;
    int exit_status;
    int signal;
    size_t n_output;
    char output[SANDBOX_MAX_OUTPUT];  // of a SANDBOX_FAULT: what went wrong
} SandboxReport;

// Run `command` through bubblewrap with the argument list `bwrap` and fill in *report. To be called
// in a fresh child of `grader`, which it ends; it allocates nothing and prints nothing.
_Noreturn void sandbox_supervise(const SandboxCommand *command, char *const *bwrap, pid_t grader,
                                 SandboxReport *report);

#endif
