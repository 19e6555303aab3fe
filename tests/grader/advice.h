// What a report offers a student to try next: looking for a fault with Oclgrind, which sees what a
// device passes over in silence, or with the sanitizers on the host. Costs no points.
#ifndef GRADER_ADVICE_H
#define GRADER_ADVICE_H

#include "manifest.h"
#include "result.h"

// Oclgrind as a driver that the OpenCL loader can be pointed to; without it `make memcheck` is not
// offered.
#define OCLGRIND_DRIVER "/usr/lib/oclgrind/liboclgrind-rt-icd.so"

// After a crash at no known line.
//   task   whose answer alone was running then; NULL where that is not known
// Returns what to try, free() it; NULL where nothing helps.
char *advice_after_crash(const Manifest *manifest, const char *task, int has_oclgrind);

// Where a kernel has `local` variables, which no answer needs: a device that lets the work-items of
// a group take turns hides that they share them.
//   folder   the files that were handed in
// Returns what to try, free() it; NULL where no kernel has one.
char *advice_on_local(const Manifest *manifest, const char *folder, int has_oclgrind);

// Where the submission came to its end and drew pixels that are wrong in a way that looks like no
// known mistake, and the answer does what Oclgrind could find a fault in: it uses an array, or
// declares what it does not set.
//   answers   for each task what stands in its hole; NULL: as it was handed out, or not known
// Returns what to try, free() it; NULL where all is explained, or nothing would be found.
char *advice_on_pixels(const Manifest *manifest, const char *const answers[], const Result *result);

#endif
