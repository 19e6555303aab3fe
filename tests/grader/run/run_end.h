// What the end of a sandboxed run means for the student, in words, and what a run may use.
//
// Used by variant_end.c.
#ifndef GRADER_RUN_END_H
#define GRADER_RUN_END_H

#include "sandbox.h"
#include "sections.h"

// What a compiler or a probe may use; what is not called TOTAL, N_PROCESSES or N_FILES is for each
// of its processes. An address space below 1 GB starves PoCL's compiler.
enum {
    MEMORY_MB = 4096,
    FILE_MB = 64,
    N_PROCESSES = 512,
    TOTAL_MEMORY_MB = 6144,
    TOTAL_FILE_MB = 256,
    N_FILES = 10000,
};

// A second way of PoCL's to compile a kernel. Its first one gives up on some that are right: PoCL 6
// with LLVM 18 checks there what only LLVM's own tests should check, and aborts the program.
#define SECOND_COMPILER "POCL_WORK_GROUP_METHOD=cbs"

// Did a run end as it does when the driver's compiler gives up on a kernel: by abort() or exit(1)?
// A student's answer may end so, too, and nothing that it cannot write tells the two apart: what
// the compiler prints, it can print as well. So a second try is made, and nobody is blamed.
int run_end_is_as_compilers(const SandboxResult *result);

// Why a run did not come to its end by itself with status 0, or NULL when it did. Of what it
// printed only the name of an OpenCL error is passed on. Owned by the caller.
//   allowed   what it might use
char *run_end_describe(const SandboxResult *result, SandboxTime allowed);

// The same of a probe, whose exit status says nothing: its answers must have their end, too.
char *run_end_of_probe(const SandboxResult *result, SandboxTime allowed, const Sections *answers);

// What else there is to say about a run, which costs nothing: "" for most. Owned by the caller.
//   is_second   it came to its end with SECOND_COMPILER, after one that did not
char *run_habits_describe(const SandboxResult *result, int is_second);

#endif
