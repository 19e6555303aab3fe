// A student's single files of a flat export, collected in a folder under the student's own names
// for them, as if the folder had been handed in.
#ifndef CLASS_LOOSE_FILES_H
#define CLASS_LOOSE_FILES_H

#include "export.h"

// Collect the entries from `begin` to before `end`, one attempt, in a new folder. No link is
// followed. Returns 0, or -1 after one message on stderr.
int loose_files_collect(const Export *export, int begin, int end, const char *folder);

#endif
