// Where a run was when it ended: which of the student's functions, with which input or scene.
//
// The probe notes that in a file (probes/note.h), which the student's code can write as well. The
// lab's judge says what a note about a step of its lab means (judge_place()).
// Used by variant_end.c and session.c.
#ifndef GRADER_RUN_PLACE_H
#define GRADER_RUN_PLACE_H

#include "note.h"

typedef struct RunPlace {
    char where[64];    // "in split_box", "while your kernels were compiled"; "": not known
    char task[64];     // the id of the task that is asked there alone, or ""
    char with[240];    // "input 17 of 400: box x [0, 4] y [0, 2]", "random scene, 9 circles", or ""
    char suspect[64];  // what a crash there comes from: "taken from an empty stack: ...", or ""
} RunPlace;

// The note in the folder that the probe wrote to, or one that means nothing: neither a link is
// followed nor a FIFO waited for. If many inputs were tried together, its input is the first that
// was not answered.
ProbeNote run_note_load(const char *out);

// What a note from before the first step means, the same in every lab; "" for a later one.
RunPlace run_place_before(const ProbeNote *note);

// Is it the name of a step, with nothing behind its end?
int run_note_is_name(const ProbeNote *note);

#endif
