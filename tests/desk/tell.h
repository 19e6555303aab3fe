// What the desk tells when asked: one hint more, and how far a student has come.
#ifndef DESK_TELL_H
#define DESK_TELL_H

#include "manifest.h"

#include <jansson.h>

// Print the next hint for the first fault of the lab's last grading, and note that it was shown.
// Returns 0; 1 where there is none to show, which is said; -1 after one message.
int tell_hint(const Manifest *lab);

// Print a line for each task that failed, in the form of a compiler's message, so that editors find
// the place (.vscode/tasks.json): below an empty line, where the answer begins in labs/, and what
// is wrong with it.
void tell_places(const Manifest *lab, const json_t *results);

// Print a line for each lab that is here, and what is next. Returns 0, or -1 after one message.
int tell_progress(void);

#endif
