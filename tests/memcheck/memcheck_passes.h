// Running a submission's probe under clang's sanitizers, and what was found.
//
// Read next: sanitizer_log.h.
#ifndef GRADER_MEMCHECK_PASSES_H
#define GRADER_MEMCHECK_PASSES_H

#include "session.h"

// The job of the memory sanitizer's pass, which is small: job/job.small.
#define MEMCHECK_SMALL_JOB ".small"

// One submission under the sanitizers.
typedef struct Memcheck {
    Session session;
    Variant whole;
    int has_trouble;  // it did not run to its end
    int has_finding;
} Memcheck;

// Run the submission, whose files are in the folder, until something is found: that is told on
// stdout, and the run is over. If a run does not come to its end, it is told how it ended. Returns
// 0, or -1 after one message when the machinery failed.
int memcheck_passes(Memcheck *memcheck);

#endif
