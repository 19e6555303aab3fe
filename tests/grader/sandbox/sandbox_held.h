// What processes hold: open files and mappings of memory, how many there are; and what no look into
// folders finds, files that were removed and still take up a disk or memory, as they are open,
// mapped or running.
#ifndef GRADER_SANDBOX_HELD_H
#define GRADER_SANDBOX_HELD_H

#include "sandbox.h"

#include <sys/types.h>

enum { HELD_SLOTS = 8192 };

// All zero at first.
typedef struct Held {
    long long n_bytes;         // of all, each counted once
    long long n_shared_bytes;  // of memory that processes share without a file: it stays where only
                               // one page of it is still mapped. 0 to who is not root
    int n_open;                // files that are open
    int n_mappings;            // of memory, long ones as several
    int n_seen;
    struct {
        dev_t device;
        ino_t number;  // 0: the slot is free
    } seen[HELD_SLOTS];
} Held;

// Add those that a process holds; `thread` is the id of one of its threads that is alive. What is
// only mapped has a size for root alone; to others each is as large as a file may be, `largest`
// bytes. It is read no further than SANDBOX_MAX_OPEN_FILES and SANDBOX_MAX_MAPPINGS are passed.
void held_add(pid_t thread, long long largest, Held *held);

#endif
