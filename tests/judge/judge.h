// What a lab's judge is made of: its checks, the job it sets, and how it judges the answers.
//
// The grader runs the same job for the solution and for the submission, and for each task with a
// failed check a job with the answer to that task alone, and asks the judge about each. One table a lab: judge_00.c and on.
#ifndef GRADER_JUDGE_H
#define GRADER_JUDGE_H

#include "result.h"
#include "sections.h"

#include <stdint.h>
#include <stdio.h>

// What a check looks at: the farther down, the more answers have a part in it.
typedef enum CheckScope {
    IS_OWN,     // the answer to its task, on inputs of its own
    IS_CALLER,  // the same, but it calls the answer to another task
    IS_WHOLE,   // what comes of the answers to all tasks
} CheckScope;

typedef struct Check {
    const char *id;
    const char *title;
    const char *task;
    int points;
    CheckScope scope;
} Check;

typedef enum VerdictKind {
    VERDICT_PASSED,
    VERDICT_FAILED,
    VERDICT_MISSING,  // the probe ended before it could answer
} VerdictKind;

typedef struct Verdict {
    VerdictKind kind;
    char *message;  // what is wrong; NULL unless VERDICT_FAILED; owned
} Verdict;

// Passed when message is NULL, else failed. Takes the message over.
Verdict verdict_of(char *message);

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

// Which labs can be judged here, as the end of a sentence: "is only 03-kdtree-2d-render", "are
// 00-hello-pixels, ...". Written to `text`, cut to n_bytes, and returned.
const char *judges_list(char *text, size_t n_bytes);

#endif
