// What a sandboxed command can see and touch, written as an argument list for bubblewrap.
#ifndef GRADER_BWRAP_ARGUMENTS_H
#define GRADER_BWRAP_ARGUMENTS_H

#include "sandbox.h"

// The descriptor that bwrap reports on: the command's start and its exit code, as JSON.
#define BWRAP_STATUS_DESCRIPTOR 9

// The NULL-terminated argument list for execvp(); release with bwrap_arguments_free(). Returns NULL
// after one message on stderr when memory runs out, a mount's folder does not exist or a variable
// of the environment has no '='.
char **bwrap_arguments(const SandboxCommand *command);
void bwrap_arguments_free(char **arguments);

#endif
