// A user that only one run has: what sandboxes without namespaces keep runs apart by.
#ifndef GRADER_SANDBOX_USER_H
#define GRADER_SANDBOX_USER_H

#include "folder.h"

#include <sys/types.h>

// The number of the user, and of its group, that belongs to the calling process alone.
uid_t user_own(void);

// As root: become a user, for good, with the group of the same number and no other. As somebody
// else: stay who one is. Returns 0, or -1 with errno set.
int user_become(uid_t user);

// As root: kill all that runs as a user whom user_own() has given. Waits until the signals are
// sent, not until everything is gone.
void user_end(uid_t user);

// Can a process here become that user, and its group? In many a container there are few of them.
int user_is_known(uid_t user);

// What it leaves outside of its folders, where everybody may write: add that to *size; stop once
// that holds more than n_files_most.
void leftovers_measure(uid_t user, long long n_files_most, FolderSize *size);

// Remove it, when none of the user's processes is alive.
void leftovers_remove(uid_t user);

#endif
