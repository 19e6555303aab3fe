// What a lab's judge is made of: its checks, the job it sets, and how it judges the answers.
//
// The grader runs the same job for the solution and for the submission, and for each task with a
// failed check a job with the answer to that task alone, and asks the judge about each. One table
// a lab: judge_00.c and on.
#ifndef JUDGE_JUDGE_H
#define JUDGE_JUDGE_H

#include "result.h"
#include "sections.h"
#include "verdict.h"

#include <stdint.h>
#include <stdio.h>

// Passed when message is NULL, else failed. Takes the message over.
Verdict verdict_of(char *message);

// Has it passed? Releases the message.
int verdict_passes(Verdict verdict);

extern const Verdict verdict_missing;

typedef struct Judge {
    const char *lab;
    const Check *checks;
    int n_checks;
    // Draw a job from the seed and write it as sections. Returns the job, with all that is
    // expected, or NULL after one message on stderr.
    void *(*job_new)(uint64_t seed, FILE *file);
    void (*job_free)(void *job);
    // Judge check number `check` by the answers.
    Verdict (*judge)(const void *job, int check, const Sections *answers);
    // Write what the probe shall try of one task's answer alone (grader/alone.h) as sections.
    // Returns 0, or -1.
    int (*write_alone)(const void *job, const char *task, FILE *file);
    // Does check number `check` pass by what the answer to its task does alone?
    int (*passes_alone)(const void *job, int check, const Sections *answers);
    // From now on compare pictures with these, which the solution drew on this device and which
    // have just passed every check against the oracle. Never called where there is no solution.
    void (*adopt)(void *job, const Sections *answers);
    // Add pictures for the report: those that are wrong first.
    void (*add_pictures)(const void *job, const Sections *answers, Result *result);
} Judge;

// The judge of a lab by its name, "03-kdtree-2d-render", or its number, "03" or "3"; or NULL.
const Judge *judge_of(const char *lab);

#endif
