// Files that were removed and still take up a disk or memory, because a process holds them: open,
// or mapped into its memory. No look into folders finds them.
#ifndef GRADER_SANDBOX_REMOVED_FILES_H
#define GRADER_SANDBOX_REMOVED_FILES_H

#include <sys/types.h>

enum { REMOVED_FILES_SLOTS = 8192 };

// All zero at first.
typedef struct RemovedFiles {
    long long n_bytes;  // of all, each counted once
    int n_seen;
    struct {
        dev_t device;
        ino_t number;  // 0: the slot is free
    } seen[REMOVED_FILES_SLOTS];
} RemovedFiles;

// Add those that a process holds; `thread` is the id of one of its threads that is alive. What is
// only mapped has a size for root alone; to others each is as large as a file may be, `largest`
// bytes.
void removed_files_add(pid_t thread, long long largest, RemovedFiles *files);

#endif
