// How much time a submission's compiler and probe may use: what our solution used for the same in
// this session, times a factor. So the limit is right on any machine and device, for any job, and
// however busy the machine is.
//
// A handout has no solution. There the lab's files run in its place, as they are handed out: most
// of the time is the device's compiler's, and in each lab they use 78% to 98% of what the solution
// does. They run only once something else takes long: until then it makes no difference.
//
// A submission is run more than once: as a whole, for the line of a crash, and each failed answer
// alone. All its runs together have a limit, too, so that a grading comes to an end.
//
// Used by variant_run.c; read next: sandbox_clock.h.
#ifndef GRADER_ALLOWANCE_H
#define GRADER_ALLOWANCE_H

#include "sandbox.h"

typedef enum Step { STEP_COMPILING, STEP_RUNNING, N_STEPS } Step;

typedef struct Allowance {
    int given_seconds;              // the instructor's own limit, or 0
    SandboxTime solution[N_STEPS];  // what it used, where that is known
    int is_known[N_STEPS];
    struct Variant *yardstick;  // what runs in the solution's place; NULL: nothing, or it has run
    int is_for_one;  // all that runs is one submission's: together it may use allowance_total()
    int is_endless;  // the whole met an endless loop
    const char *endless_task;  // in whose answer; NULL: not known
    double spent;              // of that, seconds of processor time and asleep
    double deadline;           // when it must be graded, as seconds_now() has it; 0 for never
} Allowance;

// What a submission may use in a step. As long as it is not known what the solution needs, that is
// as much as for ours. Never less than a second, so that what is run at all can begin.
//   n          how many of its runs go on side by side
//   is_again   it may have the endless loop that the whole met before: then it gets less
SandboxTime allowance_of(const Allowance *allowance, Step step, int n, int is_again);

// Has a run used so much that it must be known what it may use?
int allowance_is_asked(const Allowance *allowance, SandboxTime used);

// What all runs of one submission may use together: the time of a step, running and asleep, some
// times over. Side by side with what is left of it; INFINITY where several submissions share the
// allowance. Nothing is left shortly before the deadline, nor behind it.
double allowance_total(const Allowance *allowance);
double allowance_left(const Allowance *allowance);

// What our solution may use: far more than it needs on any machine, as it ends by itself.
SandboxTime allowance_ours(void);

// Take a run of the submission off what is left of all its runs: the time that it used, or, where
// it used up its wall time without any, all.
void allowance_charge(Allowance *allowance, const SandboxResult *result);

// Note what the solution used in a step.
void allowance_note(Allowance *allowance, Step step, SandboxTime used);

#endif
