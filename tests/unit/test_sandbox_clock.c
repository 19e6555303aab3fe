// grader/sandbox_clock: whose time it was.
#include "sandbox_clock.h"
#include "surroundings.h"

// A run that used up its 300 s of wall time, of which it ran for 3 and slept for 7.
static SandboxClock run_waiting(int tells_waiting, double waited)
{
    return (SandboxClock){.used = {.processor = 3, .asleep = 7, .wall = 300},
                          .tells_waiting = tells_waiting,
                          .waited = waited};
}

Test(sandbox_clock, who_was_kept_waiting_was_starved)
{
    const SandboxClock clock = run_waiting(1, 280);
    cr_expect(clock_is_starved(&clock));
}

Test(sandbox_clock, who_was_not_waits_for_something_else)
{
    const SandboxClock clock = run_waiting(1, 2);
    cr_expect_not(clock_is_starved(&clock));
}

// Somebody else's deadline struck while it ran.
Test(sandbox_clock, who_ran_most_of_the_time_was_not_starved)
{
    const SandboxClock clock = {
        .used = {.processor = 12, .asleep = 3, .wall = 20}, .tells_waiting = 1, .waited = 5};
    cr_expect_not(clock_is_starved(&clock));
}

// Without schedstat, as in some containers, the doubt is the machine's.
Test(sandbox_clock, where_the_kernel_does_not_tell_it_is_the_machine)
{
    const SandboxClock clock = run_waiting(0, 0);
    cr_expect(clock_is_starved(&clock));
}

// Look at it once more, after so many seconds in which it ran a little.
static void look_after(SandboxClock *clock, double seconds, double ran, const ProcessScan *seen)
{
    static ProcessScan scan;
    scan = *seen;
    scan.n_awake = 1;
    scan.tells_waiting = 1;
    scan.processor_seconds = clock->used.processor + ran;
    clock->last_look -= seconds;
    clock_look(clock, &scan);
}

// The thread that is left waited before the other's end, too.
Test(sandbox_clock, waiting_is_added_from_look_to_look_and_a_threads_end_takes_nothing_back)
{
    static SandboxClock clock;
    clock_start(&clock);
    look_after(&clock, 10, 0.5,
               &(ProcessScan){.n_waits = 2, .waits = {{10, 11, 6, 0}, {10, 12, 1, 0}}});
    look_after(&clock, 10, 0.5, &(ProcessScan){.n_waits = 1, .waits = {{10, 12, 5, 0}}});
    look_after(&clock, 10, 0.5,
               &(ProcessScan){.n_waits = 2, .waits = {{10, 13, 2, 0}, {10, 12, 5, 0}}});
    cr_expect_float_eq(clock.waited, 5.5 + 3.5 + 1.5, 1e-9, "%g", clock.waited);
    cr_expect_eq(clock.used.asleep, 0);
}

// Of a thread that is new, or whose number is an older one's: no more than the time since then.
Test(sandbox_clock, nobody_waits_longer_than_time_has_passed)
{
    static SandboxClock clock;
    clock_start(&clock);
    look_after(&clock, 10, 0, &(ProcessScan){.n_waits = 1, .waits = {{10, 11, 500, 0}}});
    cr_expect_float_eq(clock.waited, 10, 0.5, "%g", clock.waited);
}

// Work of 15 ms and naps of 85 in turn: the naps count.
Test(sandbox_clock, what_it_did_not_run_while_nobody_kept_it_waiting_it_slept)
{
    SandboxClock clock;
    clock_start(&clock);
    clock.last_look -= 0.1;
    clock_look(&clock, &(ProcessScan){.processor_seconds = 0.015});
    cr_expect_float_eq(clock.used.asleep, 0.085, 0.005, "%g", clock.used.asleep);
}

// A look that took 0.1 s is followed by a pause of 0.7: the command slept all the while.
Test(sandbox_clock, time_in_which_nobody_looked_counts_as_slept)
{
    SandboxClock clock;
    clock_start(&clock);
    clock.looking = 0.1;
    clock.last_look -= 0.8;
    clock_look(&clock, &(ProcessScan){.processor_seconds = 0.2});
    cr_expect_float_eq(clock.used.asleep, 0.6, 0.1, "%g", clock.used.asleep);
}

// Who comes later than he meant to was kept waiting himself.
Test(sandbox_clock, time_in_which_a_busy_machine_kept_us_waiting_does_not)
{
    SandboxClock clock;
    clock_start(&clock);
    clock.last_look -= 20;
    clock_look(&clock, &(ProcessScan){0});
    cr_expect_leq(clock.used.asleep, 0.2 + 1e-9, "%g", clock.used.asleep);
}

Test(sandbox_clock, the_dearer_a_look_the_longer_the_pause_up_to_a_second)
{
    cr_expect_float_eq(clock_pause(&(SandboxClock){.looking = 0.001}), 0.1, 1e-9);
    cr_expect_float_eq(clock_pause(&(SandboxClock){.looking = 0.05}), 0.35, 1e-9);
    cr_expect_float_eq(clock_pause(&(SandboxClock){.looking = 3}), 1, 1e-9);
}

// Two hundred threads of its own wake at once for 0.03 ms each, and then wait for each other: 0.6 s
// in all, and none for longer than all of them ran.
Test(sandbox_clock, who_keeps_itself_waiting_was_not_starved)
{
    enum { N_THREADS = 200 };
    static SandboxClock clock;
    static ProcessScan scan = {.n_waits = N_THREADS};
    clock_start(&clock);
    for (int n_looks = 1; n_looks <= 10; n_looks++) {
        for (int i = 0; i < N_THREADS; i++) {
            scan.waits[i] = (ThreadWait){1, 100 + i, n_looks * 0.003 * (i + 1) / N_THREADS, 0};
        }
        look_after(&clock, 0.1, 0.006, &scan);
    }
    cr_expect_float_eq(clock.waited, 0, 1e-9, "%g", clock.waited);
}

// A thread that has waited long executes a program: it has its process's number from then on.
Test(sandbox_clock, who_executes_a_program_has_not_waited_anew)
{
    static SandboxClock clock;
    clock_start(&clock);
    look_after(&clock, 10, 0,
               &(ProcessScan){.n_waits = 2, .waits = {{10, 10, 0, 0}, {10, 11, 6, 0}}});
    look_after(&clock, 10, 0, &(ProcessScan){.n_waits = 1, .waits = {{10, 10, 6.5, 0}}});
    cr_expect_float_eq(clock.waited, 6.5, 1e-9, "%g", clock.waited);
}

// Nor who let others go first meanwhile, and does not any more.
Test(sandbox_clock, who_stood_back_has_not_been_kept_waiting)
{
    static SandboxClock clock;
    clock_start(&clock);
    look_after(&clock, 10, 0, &(ProcessScan){.n_waits = 1, .waits = {{10, 10, 8, 1}}});
    look_after(&clock, 10, 0, &(ProcessScan){.n_waits = 1, .waits = {{10, 10, 9, 0}}});
    cr_expect_float_eq(clock.waited, 1, 1e-9, "%g", clock.waited);
}
