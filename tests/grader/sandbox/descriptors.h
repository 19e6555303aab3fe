// Closing the descriptors that a process has inherited.
#ifndef GRADER_DESCRIPTORS_H
#define GRADER_DESCRIPTORS_H

// Close those from first to last that are open. Returns 0, or -1 with errno set.
int descriptors_close(int first, int last);

#endif
