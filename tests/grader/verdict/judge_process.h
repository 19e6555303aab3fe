// The judge: a program of its own, a function of lab, seed and answers to verdicts and pictures.
//
// It starts no student's code and needs no sandbox, compiler or device; it reads requests and
// writes replies, and no file (tests/judge/judge_tool.c). So a handout can hold it compiled: what
// knows the answers is never handed out as text. What it gets of a submission are the raw answers
// of a probe; where these make it end, or compute for longer than any probe's answers would, they
// are wrong and the judge is started anew.
#ifndef GRADER_JUDGE_PROCESS_H
#define GRADER_JUDGE_PROCESS_H

#include "manifest.h"
#include "result.h"
#include "run_place.h"
#include "sections.h"
#include "verdict.h"

#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>

// Answers, and the number by which they are known again. 0 is nobody's.
typedef struct Answers {
    unsigned number;
    const Sections *sections;
} Answers;

typedef struct JudgeProcess {
    const char *build;  // where its program is
    const Manifest *manifest;
    uint64_t seed;
    pid_t pid;  // 0: not running
    FILE *requests, *replies;
    Check checks[RESULT_MAX_CHECKS];
    int n_checks;
    Sections table;       // the checks' texts
    unsigned held;        // the number of the answers that it holds
    unsigned unjudged;    // of those that it could not judge
    double lost_seconds;  // of processor time, of those that ended over answers
    Answers adopted;      // the solution's, which it compares pictures with
} JudgeProcess;

// Start the judge of the manifest's lab: build/judges/NN-name. Both must have the same checks.
// `build` and the manifest must stay. Returns 0, or -1 after one message on stderr.
int judge_start(JudgeProcess *judge, const char *build, const Manifest *manifest, uint64_t seed);
void judge_stop(JudgeProcess *judge);

// Append what a probe shall try to a file: of a whole submission, or of one task's answer alone.
// Returns 0, or -1 after one message.
int judge_job(JudgeProcess *judge, const char *task, FILE *file);

// What a probe's note about a step of the lab means; all "" where it means nothing.
RunPlace judge_place(JudgeProcess *judge, const ProbeNote *note);

// Judge check number `check`. The diagnosis is owned by the caller.
Verdict judge_verdict(JudgeProcess *judge, Answers answers, int check);

// Does it pass by what the answer to its task did alone?
int judge_passes_alone(JudgeProcess *judge, Answers answers, int check);

// The known mistake that explains why it does not, where stubs have a part in that: a diagnosis
// with a cause and its kind, and without facts; or NOTHING_WRONG where none is known. Owned by the
// caller.
Diagnosis judge_alone_cause(JudgeProcess *judge, Answers answers, int check);

// From now on pictures are compared with these, the solution's, which have just passed every check.
// They must stay. Returns 0, or -1 after one message.
int judge_adopt(JudgeProcess *judge, Answers answers);

// Add pictures for the report, those that are wrong first. Returns 0, or -1 after one message.
int judge_add_pictures(JudgeProcess *judge, Answers answers, Result *result);

#endif
