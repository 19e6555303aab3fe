// A small job for Oclgrind, which is a thousand times slower than a device: the lab's own job with
// fewer calls, fewer scenes and pictures of at most 16x16 pixels.
//
// What comes out is not judged, so that a scene is only scaled down, not drawn anew. Read next:
// memcheck.c.
#ifndef GRADER_MEMCHECK_JOB_H
#define GRADER_MEMCHECK_JOB_H

#include "sections.h"

#include <stdio.h>

// Write the small job. The entry behind the end of each array, which shows in a picture that a loop
// runs one step too far, is left out: here the array ends where it ends. Returns 0, or -1 after one
// message.
int memcheck_job_write(const Sections *job, FILE *file);

#endif
