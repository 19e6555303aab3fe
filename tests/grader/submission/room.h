// Is there room for so many bytes in a folder?
//
// Who fills a disk? Where there is room for what every submission may need, it is the one that
// needs more; where there is none, the machine. Used by unpack_run.c and unpack_tool.c.
#ifndef GRADER_ROOM_H
#define GRADER_ROOM_H

// Write a file of n_megabytes into an open folder, and remove it again. Returns 0, or -1 with errno
// set.
int room_try(int folder, int n_megabytes);

#endif
