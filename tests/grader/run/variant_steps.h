// The two steps of a variant, compiling and running, in the order in which they are walked:
// variant_run.c has a step's folder made (variant.c) and starts it (variant_start.c); once it has
// ended, what that says is taken (variant_end.c). Used by these alone.
#ifndef GRADER_VARIANT_STEPS_H
#define GRADER_VARIANT_STEPS_H

#include "variant.h"

// Remove what an earlier variant of this name, or an earlier run of this one, wrote. Returns 0, or
// -1 after one message.
int step_folder_remove(const Variant *variant, Step step);

// Likewise, and make the folder that the step writes to: empty, closed to all but the run, of
// limited size where that can be had. (Behind Landlock the old files belong to a user that is
// gone.) Returns 0, or -1 after one message.
int step_folder_make(const Variant *variant, Step step);

// Start a step in a sandbox: the compiler on the lab's host files, or the probe. Returns NULL after
// one message when the machinery failed.
SandboxRun *step_sandbox(const Workdir *workdir, const Variant *variant, Step step,
                         SandboxTime time);

// Take what the end of a step says about the variant: whether it compiles; what it answered, or why
// it did not come to its end. May take result->output over.
void step_end_take(const Workdir *workdir, Variant *variant, Step step, SandboxResult *result);

#endif
