// What /proc says of a process, or of one of its threads: what it does, and how it is scheduled.
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

#endif
