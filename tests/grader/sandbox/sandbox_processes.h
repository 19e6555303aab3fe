// What a sandboxed command and all that it has started use together.
#ifndef GRADER_SANDBOX_PROCESSES_H
#define GRADER_SANDBOX_PROCESSES_H

#include "sandbox_walls.h"

#include <sys/types.h>

// More processes and threads than this need not be looked at: the limit is far below.
enum { SCAN_MAX_TASKS = 4096 };

typedef struct ThreadWait {
    pid_t process, thread;
    double seconds;     // that it has waited for a processor, since it began
    int is_own_choice;  // it lets others go first
} ThreadWait;

typedef struct ProcessScan {
    int n_processes;      // that are alive
    int n_tasks;          // processes and threads, also those that only wait to be reaped
    long long memory_kb;  // in use
    int n_mappings;       // of memory, and open files: read until they are too many
    int n_open;
    long long n_bytes;  // on disks: in the folders it writes, and of removed files still open
    long long n_files;  // in the folders it writes, and in those in memory
    int n_awake;        // threads that run, or wait for a processor or a disk
    int tells_waiting;  // the kernel says how long threads wait for a processor
    ThreadWait waits[SCAN_MAX_TASKS];  // of the threads that are alive
    int n_waits;
    double processor_seconds;  // used by those alive, and by children that they waited for
} ProcessScan;

// Look at the calling supervisor's descendants: processes, memory and time. The child `outermost`,
// which is the grader's own, is not counted, what it has started is; -1 to count every one.
void scan_processes(const Walls *walls, pid_t outermost, ProcessScan *scan);

// Is a process of the run's own user alive that is no child of this one and cannot become one?
int scan_has_strays(const Walls *walls);

// Look into the folders that the command may write.
void scan_folders(const Walls *walls, ProcessScan *scan);

// The first limit that has been passed.
SandboxLimit scan_limit(const ProcessScan *scan, const SandboxCommand *command);

// Kill all children of the calling process.
void scan_kill_children(void);

#endif
