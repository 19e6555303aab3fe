// The two steps of a variant, compiling and running: their folders, and starting them. Used by
// variant.c and variant_run.c alone.
#ifndef GRADER_VARIANT_STEPS_H
#define GRADER_VARIANT_STEPS_H

#include "variant.h"

// Make the folder that a step writes to: empty, closed to all but the run, of limited size where
// that can be had. Returns 0, or -1 after one message.
int step_folder_make(const Workshop *workshop, const char *variant, Step step);

// Remove what an earlier variant of this name wrote. Returns 0, or -1 after one message.
int step_folder_remove(const Workshop *workshop, const char *variant, Step step);

// Both: behind Landlock the old files belong to a user that is gone. Returns 0, or -1 after one
// message.
int step_clear(const Workshop *workshop, const char *variant, Step step);

// Start a step in a sandbox: the compiler on the lab's host files, or the probe. Returns NULL after
// one message when the machinery failed.
SandboxRun *step_sandbox(const Workshop *workshop, const Variant *variant, Step step,
                         SandboxTime time);

#endif
