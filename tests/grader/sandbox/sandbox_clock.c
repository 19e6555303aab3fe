// The three kinds of time of a run (see sandbox_clock.h).
#include "sandbox_clock.h"

#include <math.h>
#include <string.h>
#include <sys/random.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

// A run is looked at again after so long; or, so that looking costs an eighth of a processor, after
// seven times the processor time that the last look took. But not later than after a second, as it
// may do a nonce meanwhile.
#define PAUSE_SECONDS 0.1
#define PAUSE_FACTOR 7.0
#define MOST_PAUSE_SECONDS 1.0

// How late a look may be and still tell of all the time before it: while a busy machine kept us
// waiting, it may have kept the command waiting as well.
#define LATE_SECONDS 0.1

// Starved is whom others kept waiting for a processor in so much of the time in which it neither
// ran nor slept. Not all: what a thread waited since the last look before it ended is not seen.
#define STARVED_SHARE 0.3

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double seconds_own(void)
{
    struct timespec own;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
    return (double)own.tv_sec + 1e-9 * (double)own.tv_nsec;
}

double clock_pause(const SandboxClock *clock)
{
    return fmin(fmax(PAUSE_SECONDS, PAUSE_FACTOR * clock->looking), MOST_PAUSE_SECONDS);
}

double clock_next_look(const SandboxClock *clock)
{
    unsigned short drawn = 0;
    (void)!getrandom(&drawn, sizeof drawn, GRND_NONBLOCK);
    return seconds_now() + clock_pause(clock) * (0.5 + 0.5 * drawn / 65535);
}

double clock_ended_children(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

void clock_start(SandboxClock *clock)
{
    *clock = (SandboxClock){.start = seconds_now()};
    clock->last_look = clock->start;
}

// How long a thread had waited at the last look. One that executes a program becomes the first of
// its process, by number, and keeps its time: of the first one, the longest of all counts.
static double last_wait(const SandboxClock *clock, const ThreadWait *wait)
{
    double longest = 0;
    for (int i = 0; i < clock->n_waits; i++) {
        const ThreadWait *last = &clock->waits[i];
        if (last->thread == wait->thread ||
            (wait->thread == wait->process && last->process == wait->process)) {
            longest = fmax(longest, last->seconds);
        }
    }
    return longest;
}

// The longest that any one thread has waited for a processor since the last look, and not by its
// own choice. Not all together: a hundred that wait for each other for a moment would make a long
// time of it.
static double longest_wait(const SandboxClock *clock, const ProcessScan *scan)
{
    double longest = 0;
    for (int i = 0; i < scan->n_waits; i++) {
        const ThreadWait *wait = &scan->waits[i];
        if (!wait->is_own_choice) {
            longest = fmax(longest, wait->seconds - last_wait(clock, wait));
        }
    }
    return longest;
}

void clock_look(SandboxClock *clock, const ProcessScan *scan)
{
    const double now = seconds_now();
    const double between = now - clock->last_look;
    const double processor = scan->processor_seconds + clock_ended_children();
    // A process that ends is counted now here, now there: the sum may seem to shrink for a moment.
    const double ran = processor > clock->used.processor ? processor - clock->used.processor : 0;
    // Short naps and short work in turn: what it did not run it slept, as nobody kept it waiting.
    // That holds for all the time in which we chose not to look, or were still looking.
    if (scan->n_awake == 0 && ran < between) {
        const double unseen = clock_pause(clock) + clock->looking;
        clock->used.asleep += fmin(between - ran, unseen + LATE_SECONDS);
    }
    clock->tells_waiting |= scan->tells_waiting;
    // Who waits for the run's own threads waits while at least one of them runs.
    clock->waited += fmax(0, fmin(longest_wait(clock, scan), between) - ran);
    clock->n_waits = scan->n_waits;
    memcpy(clock->waits, scan->waits, (size_t)scan->n_waits * sizeof *scan->waits);
    clock->used.processor += ran;
    clock->used.wall = now - clock->start;
    clock->last_look = now;
}

int clock_is_starved(const SandboxClock *clock)
{
    const SandboxTime *used = &clock->used;
    const double rest = used->wall - used->processor - used->asleep;
    // A deadline may strike in the midst of what it does.
    return rest >= used->wall / 2 &&
           (!clock->tells_waiting || clock->waited >= STARVED_SHARE * rest);
}
