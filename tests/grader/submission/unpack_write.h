// Writing a copy of a file out of an archive into a folder; used by unpack.c alone.
#ifndef GRADER_UNPACK_WRITE_H
#define GRADER_UNPACK_WRITE_H

#include "copies.h"

// Write a copy where its path leads. In place of a link comes a link to nowhere, in place of
// anything else that is no file a folder, so that staging says what was there. What cannot be
// written (a name that this file system does not take, another copy in its way) is passed over.
//   folder   open
// Returns 0, or -1 with errno set when the folder is at fault.
int copy_write(const Copy *copy, int folder);

#endif
