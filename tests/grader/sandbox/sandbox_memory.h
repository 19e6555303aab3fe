// How much memory a process uses, by what /proc tells of it.
#ifndef GRADER_SANDBOX_MEMORY_H
#define GRADER_SANDBOX_MEMORY_H

#include <sys/types.h>

typedef struct ProcessMemory {
    long long own_kb;  // in the memory of the machine or swapped out, and the tables of its pages
    long long shared_kb;  // of what it shares with others without a file, the pages that it has
} ProcessMemory;

// A thread of the process by which /proc tells of it, and its memory: quick to read, and never too
// small, as what processes share after a fork is in the figure of each. Returns 0 when the process
// has ended.
pid_t memory_look(pid_t process, ProcessMemory *memory);

// Its share of what it uses: exact, but the kernel has to walk through all of its pages. Returns 0,
// or -1 when the process has ended.
int memory_share(pid_t process, ProcessMemory *memory);

#endif
