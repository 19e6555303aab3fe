// When a report offers `make memcheck`: Oclgrind sees what a device passes over in silence.
#ifndef GRADER_MEMCHECK_ADVICE_H
#define GRADER_MEMCHECK_ADVICE_H

#include "manifest.h"
#include "result.h"

// Oclgrind as a driver that the OpenCL loader can be told of; without it nothing is offered.
#define OCLGRIND_DRIVER "/usr/lib/oclgrind/liboclgrind-rt-icd.so"

// Note the offer under the stage "Running", where the submission's kernels crashed or drew pixels
// that are wrong in a way that looks like no known mistake. Costs no points.
//   crashed        the submission as a whole ended by a signal, at no known line
//   is_untouched   for each task: does it stand as it was handed out?
void memcheck_advise(const Manifest *manifest, int crashed, const int *is_untouched,
                     Result *result);

#endif
