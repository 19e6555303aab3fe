// Writing bytes to an open file, and what goes with it.
#ifndef GRADER_BYTES_WRITE_H
#define GRADER_BYTES_WRITE_H

#include <stddef.h>
#include <time.h>

// Write all of them: write() may take a part, or be interrupted. Returns 0, or -1 with errno set.
int bytes_write(int descriptor, const void *bytes, size_t n_bytes);

// Write a file of n_megabytes into an open folder, and remove it again. Returns 0, or -1 with errno
// set.
//
// Who fills a disk? Where there is room for what every submission may need, it is the one that
// needs more; where there is none, the machine.
int room_try(int folder, int n_megabytes);

// Give an open file this time of its last change. One that no file system takes says nothing.
void time_set(int descriptor, time_t changed);

// Close it, and leave errno as it was: it tells of what failed before. Returns `outcome`; or -1
// with errno set, where that is 0 and closing fails.
int close_after(int descriptor, int outcome);

#endif
