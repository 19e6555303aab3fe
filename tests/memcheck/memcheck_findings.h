// Telling what Oclgrind found at the student's own lines.
//
// Used by memcheck_passes.c, as soon as something is found.
#ifndef GRADER_MEMCHECK_FINDINGS_H
#define GRADER_MEMCHECK_FINDINGS_H

#include "memcheck_passes.h"

// The first finding in one of the files that a student hands in, or NULL. What goes wrong in a
// given file mostly follows from what goes wrong in the student's.
const Finding *finding_first_own(const Memcheck *memcheck);

// Print a finding: file, line, what it is, the line itself, the task and the work-item.
void finding_print(const Memcheck *memcheck, const Finding *finding);

#endif
