// Telling what a sanitizer found at the student's own line.
//
// Used by memcheck_passes.c.
#ifndef GRADER_MEMCHECK_FINDINGS_H
#define GRADER_MEMCHECK_FINDINGS_H

#include "memcheck_passes.h"
#include "sanitizer_log.h"

// Print a finding: file, line, what it is, the line itself, the task, the work-item and what to do.
void finding_print(const Memcheck *memcheck, const Finding *finding);

#endif
