// Who clears up when the grader is ended from outside, by Ctrl-C or a kill: a process that waits
// for its end.
#ifndef GRADER_JANITOR_H
#define GRADER_JANITOR_H

#include <sys/types.h>

typedef struct Janitor {
    pid_t pid;     // 0: there is none
    int lifeline;  // closed by the grader's end, however it comes
} Janitor;

// Start one, which calls clear(what) once this process has ended without janitor_dismiss(): a few
// times within two seconds, as its sandboxes end beside it, until it returns 0. Returns 0, or -1
// with errno set.
int janitor_start(Janitor *janitor, int (*clear)(void *what), void *what);

// Clearing up was done: send it away, and wait until it has gone. One that was not started is fine.
void janitor_dismiss(Janitor *janitor);

#endif
