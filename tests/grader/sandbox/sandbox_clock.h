// Whose time it is: processor time, time asleep and wall time of a sandboxed command.
//
// Wall time says nothing about a command: on a busy machine, or in a container of a quarter of a
// processor, a right answer takes ten times as long. What it used of a processor is the same there.
// A command that waits for what never comes uses none, as does one that gets none: what its threads
// do says which, asleep or ready to run.
#ifndef GRADER_SANDBOX_CLOCK_H
#define GRADER_SANDBOX_CLOCK_H

#include "sandbox_processes.h"

typedef struct SandboxClock {
    double start, last_look;  // on the monotonic clock, seconds
    double looking;           // processor time of our own that the last look took
    SandboxTime used;
    int tells_waiting;                 // the kernel does; else the two below say nothing
    double waited;                     // seconds that others kept it waiting for a processor
    ThreadWait waits[SCAN_MAX_TASKS];  // as they were at the last look
    int n_waits;
} SandboxClock;

// The monotonic clock, in seconds; and the processor time of the calling process.
double seconds_now(void);
double seconds_own(void);

void clock_start(SandboxClock *clock);

// Take in what the scan has just seen.
void clock_look(SandboxClock *clock, const ProcessScan *scan);

// How long to wait at most after the last look: the longer that took, the longer, as a run can make
// looking at it dear.
double clock_pause(const SandboxClock *clock);

// When to look again, on the monotonic clock: after half of that at least, at a time that the run
// cannot foresee. Else it could be awake at each look, and sleep until the next.
double clock_next_look(const SandboxClock *clock);

// Is the machine to blame that it used up its wall time? It is where the command was kept waiting
// for a processor, not where it slept, or hid what it ran. Where the kernel does not tell, it is.
int clock_is_starved(const SandboxClock *clock);

// What the calling supervisor's children that have ended used of processors, in seconds.
double clock_ended_children(void);

#endif
