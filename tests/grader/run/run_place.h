// Where a run was when it ended: which of the student's functions, with which input or scene.
//
// The probe notes that in a file (probes/note.h), which the student's code can write as well. So of
// the note only what a table here holds becomes words, and numbers that the job has.
// Used by variant_run.c.
#ifndef GRADER_RUN_PLACE_H
#define GRADER_RUN_PLACE_H

#include "note.h"

typedef struct RunPlace {
    const char *where;  // "in split_box", "while its kernels were compiled"; NULL: not known
    const char *task;   // the id of the task that is asked there alone, or NULL
    char with[160];     // "input 17 of 400: box x [0, 4] y [0, 2]", "random scene, 9 circles"
} RunPlace;

// The note in a file, or one that means nothing: neither a link is followed nor a FIFO waited for.
ProbeNote run_note_load(const char *path);

// What a note means for a lab and its job.
RunPlace run_place_find(const char *lab, const Sections *job, const ProbeNote *note);

#endif
