// What a sandboxed command can see and touch, written as an argument list for bubblewrap.
#ifndef GRADER_BWRAP_ARGUMENTS_H
#define GRADER_BWRAP_ARGUMENTS_H

#include "sandbox.h"

// The NULL-terminated argument list for execvp(); release with bwrap_arguments_free(). The mounts'
// folders are absolute paths, as bwrap is started in another folder. Returns NULL after one message
// on stderr when memory runs out.
char **bwrap_arguments(const SandboxCommand *command);
void bwrap_arguments_free(char **arguments);

// Folders in memory have their own bounds, as no limit on processes counts what they hold.
#define BWRAP_TMP_BYTES 268435456  // PoCL's cache, the compiler's temporary files
#define BWRAP_SHM_BYTES 67108864

#endif
