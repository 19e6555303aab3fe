// The jobs of memcheck: the lab's own without the entries behind ends of arrays, and a small one
// for the memory sanitizer, which takes twenty times as long as the address sanitizer.
//
// What comes out is not judged, so that a scene is only scaled down, not drawn anew. Read next:
// memcheck.c.
#ifndef GRADER_MEMCHECK_JOB_H
#define GRADER_MEMCHECK_JOB_H

#include "sections.h"

#include <stdio.h>

// Write the judge's job. The entry behind the end of each array, which shows in a picture that a
// loop runs one step too far, is left out: here the array ends where it ends. Returns 0, or -1
// after one message.
int memcheck_job_write(const Sections *judges, FILE *file);

// Write a small job, made of one that memcheck_job_write() wrote: fewer calls, fewer scenes, and
// pictures of at most 16x16 pixels. Returns 0, or -1 after one message.
int memcheck_job_write_small(const Sections *job, FILE *file);

#endif
