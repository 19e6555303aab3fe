// Writing what an archive holds into a folder; used by unpack.c and unpack_export.c.
#ifndef GRADER_UNPACK_WRITE_H
#define GRADER_UNPACK_WRITE_H

#include "copies.h"

// Write a copy where its path leads. In place of a link comes a link to nowhere, in place of
// anything else that is no file a folder, so that staging says what was there. What cannot be
// written (a name that this file system does not take, another copy in its way) is passed over.
//   folder   open
// Returns 0, or -1 with errno set when the folder is at fault.
int copy_write(const Copy *copy, int folder);

// Make the folders of a path, "a/b", where they are not there, and open the last, none through a
// link. Returns a descriptor, or -1 with errno set.
int unpack_folder_open(int folder, const char *path);

// Give an open file the time of an entry. A time that no file system takes says nothing.
void unpack_time_set(int descriptor, time_t changed);

#endif
