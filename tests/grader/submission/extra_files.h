// What lies in a submission besides the files that were asked for.
#ifndef GRADER_EXTRA_FILES_H
#define GRADER_EXTRA_FILES_H

#include "manifest.h"

#include <stdio.h>

// Name, in one line, the entries of folder `submission` that neither were asked for nor come with
// the lab, and a manifest that is not the lab's own. None of them is opened but the manifest.
// Returns how many notes were written: 0 or 1. Of a submission that is no folder there are none.
int extra_files_note(const Manifest *manifest, const char *submission, FILE *notes);

#endif
