// The filter of system calls, one for both sandboxes.
#ifndef GRADER_SANDBOX_FILTER_H
#define GRADER_SANDBOX_FILTER_H

// The filter as the kernel takes it, to be read from the descriptor returned (close it), positioned
// at its start; -1 with errno set when it cannot be made.
int filter_open(void);

// Put this process and all that it will start under the filter read from a descriptor. Needs
// PR_SET_NO_NEW_PRIVS. Returns 0, or -1 with errno set.
int filter_enter(int descriptor);

#endif
