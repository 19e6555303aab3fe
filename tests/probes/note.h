// What a probe is about to call, in a file that outlives a crash: one note, overwritten each time.
//
// The lab's judge makes words of it with a table of its own, `steps` of judge_NN.c: the note stands
// where the student's code can write, too, and is no more than a claim.
#ifndef PROBES_NOTE_H
#define PROBES_NOTE_H

#include "sections.h"

// Where the sandbox takes it, from the folder the probe starts in.
#define PROBE_NOTE_PATH "out/note"

#define PROBE_NO_INPUT UINT32_MAX

// The answers to inputs that are tried together, one after the other, as they come: every bit of
// those that are still to come is set.
#define PROBE_ANSWERING_PATH "out/answering"

// Noted while kernels are built, ahead of all of the student's functions.
#define PROBE_NOTE_BUILD "build"

typedef struct ProbeNote {
    /*  0 */ char name[SECTION_NAME_BYTES];  // of the job's section, or of the answer; "" at first
    /* 24 */ uint32_t input;                 // which of that section's, or PROBE_NO_INPUT: all
    /* 28 */ uint32_t n_together;  // how many are answered in PROBE_ANSWERING_PATH; 0: none
} ProbeNote;

_Static_assert(sizeof(ProbeNote) == 32, "the note is written as it lies in memory");

#endif
