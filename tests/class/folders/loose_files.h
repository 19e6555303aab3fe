// A student's single files of a flat export, collected in a folder under the student's own names
// for them, as if the folder had been handed in.
#ifndef CLASS_LOOSE_FILES_H
#define CLASS_LOOSE_FILES_H

#include "export.h"
#include "manifest.h"

// Collect the entries from `begin` to before `end`, one attempt, in a new folder. No link is
// followed.
//   manifest   the lab's, without files where it is not known
// Returns 0, or -1 after one message on stderr.
int loose_files_collect(const Export *export, int begin, int end, const Manifest *manifest,
                        const char *folder);

// What entry i of them is called there: the student's own name of the file. A number that Canvas
// put at its end stays where the same student has handed in another file that is called so without
// it, or with another number: staging says which counts.
void loose_file_name(const Export *export, int begin, int end, int i, char name[NAME_MAX + 1]);

// Put a file of the open folder `from` into the open folder `to`, in place of an earlier one of
// that name. What is no regular file is left out. Returns 0, or -1 with errno set.
int loose_file_put(int from, const char *file, int to, const char *name);

#endif
