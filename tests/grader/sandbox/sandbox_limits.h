// The limits that the kernel holds each process of a sandboxed command to.
#ifndef GRADER_SANDBOX_LIMITS_H
#define GRADER_SANDBOX_LIMITS_H

#include "sandbox.h"

// Set them for this process and all that it will start. Where the grader itself runs under tighter
// ones, those stay. To be called last, as there may be little memory left afterwards. Returns 0, or
// -1 with errno set.
int limits_set(const SandboxCommand *command);

// The processes and threads that the command may have; 0 = no limit of the sandbox's or the
// grader's own.
unsigned long long limits_processes(const SandboxCommand *command);

#endif
