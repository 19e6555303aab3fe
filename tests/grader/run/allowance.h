// How much time a submission's compiler and probe may use: what our solution used for the same,
// times a factor. So the limit is right on any machine and device, and for any job.
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
    int is_packed;    // it is from allowance_read_packed()
    int is_for_one;   // all that runs is one submission's: together it may use allowance_total()
    int is_looping;   // one of its runs did not come to an end: the others may use half as much
    double spent;     // of that, seconds of processor time and asleep
    double deadline;  // when it must be graded, as seconds_now() has it; 0 for never
} Allowance;

// What a submission may use in a step. As long as it is not known what the solution needs, that is
// as much as for ours. Never less than a second, so that what is run at all can begin.
//   n   how many of its runs go on side by side
SandboxTime allowance_of(const Allowance *allowance, Step step, int n);

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

// For a handout, which has no solution to run: take in what it needed when the handout was packed,
// rounded up (handout/pack.sh), from the file SOLUTION_SECONDS_PATH. Returns 0, or -1 after one
// message on stderr.
#define SOLUTION_SECONDS_PATH "tests/solution-seconds"
int allowance_read_packed(Allowance *allowance);

#endif
