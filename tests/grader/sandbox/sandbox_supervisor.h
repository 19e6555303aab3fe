// The process that starts one sandboxed command, holds it to its limits and outlives all of it.
#ifndef GRADER_SANDBOX_SUPERVISOR_H
#define GRADER_SANDBOX_SUPERVISOR_H

#include "sandbox_walls.h"

#include <sys/types.h>

// What it found out, in memory shared with the grader.
typedef struct SandboxReport {
    // What the command may use, in seconds; the grader may change it at any time.
    _Atomic double processor_allowed, asleep_allowed, wall_allowed;
    _Atomic double processor_used, asleep_used;  // when it was looked at last
    int is_complete;                             // set last: the supervisor itself came to its end
    SandboxOutcome outcome;
    int exit_status;
    int signal;
    SandboxLimit limit;
    SandboxTime used;
    int n_left;
    unsigned long long n_printed;
    size_t n_output;
    char output[SANDBOX_MAX_OUTPUT];  // of a SANDBOX_FAULT: what went wrong
} SandboxReport;

// Run the command inside the walls, which are made and taken down here, and fill in *report. To be
// called in a fresh child of `grader`, which it ends; it prints nothing.
_Noreturn void sandbox_supervise(Walls *walls, pid_t grader, SandboxReport *report);

#endif
