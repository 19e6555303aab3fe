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

// Does a thread let others go first that the calling process would not? By its own priority, by its
// policy, or by the priority of its session, which Linux schedules as a group ("autogroup").
int stat_stands_back(pid_t process, const ThreadStat *stat);

#endif
