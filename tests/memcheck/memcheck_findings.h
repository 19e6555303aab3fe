// Telling what a sanitizer found at the student's own line.
//
// Used by memcheck_passes.c.
#ifndef GRADER_MEMCHECK_FINDINGS_H
#define GRADER_MEMCHECK_FINDINGS_H

#include "memcheck_passes.h"
#include "sanitizer_log.h"

// Print a finding: file, line, what it is, the line itself, the task, the work-item and what to do.
// Returns 1, or 0 after nothing where it is at a line that no file has.
int finding_print(const Memcheck *memcheck, const Finding *finding);

#endif
