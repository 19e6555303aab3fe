// A command that runs beside the watch, in a process group of its own: it can be ended whole.
#ifndef DESK_CHILD_H
#define DESK_CHILD_H

#include <sys/types.h>

typedef enum ChildOutput {
    CHILD_SHOWS,   // goes where the watch's own goes
    CHILD_IS_READ  // comes through `output`
} ChildOutput;

typedef struct Child {
    pid_t pid;        // 0: none runs
    int output;       // to read from, or -1
    double start_ms;  // stats_clock_ms()
    char *said;       // what was read so far, NUL-terminated; owned
    size_t said_bytes;
} Child;

// Start a command, with nothing to read on its standard input, and without what make hands down.
//   words   NULL-terminated, the program first
// Returns 0, or -1 after one message.
int child_start(Child *child, char *const words[], ChildOutput output);

// Take what it has written; call this when `output` is ready. Of very much only the first part is
// kept.
void child_read(Child *child);

// The processor time that it has used so far, on all its threads, in seconds.
double child_seconds(const Child *child);

// Has it ended? Returns 1 and its exit status (128 and more: by a signal), or 0. Its output is read
// to the end then.
int child_has_ended(Child *child, int *status);

// End it and all that it has started, and wait until it is gone. One that does not run is fine.
void child_stop(Child *child);

#endif
