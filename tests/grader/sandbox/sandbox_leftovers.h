// What a run's own user leaves outside of its folders, where everybody may write.
#ifndef GRADER_SANDBOX_LEFTOVERS_H
#define GRADER_SANDBOX_LEFTOVERS_H

#include "folder.h"

#include <sys/types.h>

// Add it to *size; stop once that holds more than n_files_most.
void leftovers_measure(uid_t user, long long n_files_most, FolderSize *size);

// Remove it, when none of the user's processes is alive.
void leftovers_remove(uid_t user);

#endif
