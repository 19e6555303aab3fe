// The learner's desk: what a student has reached, one hint more, and a watch over what is saved.
//
// It reads what the grader wrote (results.h) and never a submission: the verdict is the grader's.
// Read next: record.h, tell.h, watch.h.
#ifndef DESK_DESK_H
#define DESK_DESK_H

#include "manifest.h"

typedef struct Desk {
    const char *build;    // the build folder
    const char *native;   // that of probes which run without a driver (tests/native); NULL: none
    const char *make;     // the program that builds
    const Manifest *lab;  // the one that is asked for
    const char *options;  // of its program, in place of the manifest's `look`; NULL: those
    const char *device;   // NULL: the first
} Desk;

#endif
