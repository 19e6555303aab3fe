// The program that is process 1 of bubblewrap's sandboxes (sandbox_init_tool.c).
#ifndef GRADER_SANDBOX_INIT_H
#define GRADER_SANDBOX_INIT_H

// A descriptor to read the program from, positioned at its start; stays open on exec, close it. -1
// with errno set when it cannot be made.
int init_open(void);

#endif
