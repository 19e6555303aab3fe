// What a report offers a student to try next: looking for a fault with `make memcheck`, which sees
// what a device passes over in silence. Costs no points.
#ifndef GRADER_ADVICE_H
#define GRADER_ADVICE_H

#include "manifest.h"
#include "result.h"

// After a crash at no known line. Returns what to try, free() it.
char *advice_after_crash(const Manifest *manifest);

// Where a kernel has `local` variables, which no answer needs: a device that lets the work-items of
// a group take turns hides that they share them.
//   folder   the files that were handed in
// Returns what to say, free() it; NULL where no kernel has one.
char *advice_on_local(const Manifest *manifest, const char *folder);

// Where the submission came to its end and drew pixels that are wrong in a way that looks like no
// known mistake, and the answer has what memcheck could find a fault in: an index that may leave
// its array, or a variable that is declared without a value.
//   answers   for each task what stands in its hole; NULL: as it was handed out, or not known
// Returns what to try, free() it; NULL where all is explained, or nothing would be found.
char *advice_on_pixels(const Manifest *manifest, const char *const answers[], const Result *result);

#endif
