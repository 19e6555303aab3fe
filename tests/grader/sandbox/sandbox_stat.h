// What /proc says of a process, or of one of its threads: what it does, how it is scheduled, and
// how much memory it uses.
#ifndef GRADER_SANDBOX_STAT_H
#define GRADER_SANDBOX_STAT_H

#include <sys/types.h>

typedef struct ThreadStat {
    char state;      // R runs or waits for a processor, D waits for a disk, S sleeps, X has ended
    double seconds;  // of processors; of a process with those of the children it waited for
    int nice;        // from -20 to 19: the higher, the later its turn
    int policy;      // SCHED_OTHER, SCHED_IDLE, ...
} ThreadStat;

// Read /proc/P/stat or /proc/P/task/T/stat.
ThreadStat stat_read(const char *path);

// Does a thread let others go first that the calling process would not, by its own priority or its
// policy? Does a process by that of its session, which Linux schedules as a group ("autogroup")?
int stat_stands_back(const ThreadStat *stat);
int stat_session_stands_back(pid_t process);

// Read the figures of some names, "Name:   123 kB", in a file that /proc has of a process. Those
// that it does not name become -1. Returns 0, or -1 when there is no such process any more.
int stat_figures_read(pid_t process, const char *file_name, const char *const names[],
                      long long figures[], int n);

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
