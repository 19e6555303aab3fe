// A session: one lab, one seed, one device; the solution's answers, and variants judged beside
// them.
//
// Used by grade.c for a submission and by mutants.c for many known-wrong answers in a row. Read
// next: variant.h, judge_process.h.
#ifndef GRADER_SESSION_H
#define GRADER_SESSION_H

#include "judge_process.h"
#include "manifest.h"
#include "result.h"
#include "settings.h"
#include "variant.h"

typedef struct Session {
    const Settings *settings;
    JudgeProcess judge;
    JudgeProcess further[MAX_FURTHER_JOBS];  // of the seeds that follow; workdir.n_further_jobs
    Manifest manifest;
    Workdir workdir;
    int has_solution;      // 0 in a handout: the oracle alone judges
    Variant solution;      // or where there is none, the lab's files as they are handed out
    int has_kept_answers;  // they were kept (kept_answers.h): the solution is not run again
    Allowance allowance;   // how long what is handed in may take
} Session;

// Prepare everything up to the point where variants can run: manifest, workdir, job, and the
// solution, where there is one, as a variant that has not run yet. With settings->kept_answers the
// solution's answers are taken from there, or kept there once they are trusted. The settings must
// outlive the session. Returns 0, or -1 after one message on stderr.
int session_open(Session *session, const Settings *settings);
void session_close(Session *session);

// Before anything runs: let each variant also try the jobs of the n seeds that follow on the
// settings'. n is MAX_FURTHER_JOBS at most. Returns 0, or -1 after one message.
int session_add_seeds(Session *session, int n);

// Write the judge's job for a whole submission, or, where a task is named, for its answer alone.
// Returns 0, or -1 after one message.
int session_write_job(JudgeProcess *judge, const char *task, const char *path);

// Compile n variants side by side, the solution first where it is one of them. Returns 0, or -1
// after one message when the machinery failed.
int session_compile(Session *session, Variant *const variants[], int n);

// Likewise run n variants, and compile those that are not yet.
int session_run(Session *session, Variant *const variants[], int n);

// After they have run side by side: if the solution did not come to its end, run all that did not
// once more, one after the other. One may have taken what the others needed, such as the room on a
// disk: whoever did so fails again. Returns 0, or -1 after one message.
int session_run_apart(Session *session, Variant *const variants[], int n);

// After the solution has run: it must pass every check on this device, judged by the oracle, else
// nothing that is said about a submission can be trusted. From then on pictures are compared with
// the solution's. Returns 0, or -1 after one message; 0 where there is no solution.
int session_trust_solution(Session *session);

// The device's name as a variant's probe saw it: "none" where it never came so far, "host" for labs
// that use none.
void session_device_name(const Session *session, const Variant *variant, char *name,
                         size_t n_bytes);

// What goes into the hole of one of the lab's tasks.
typedef struct HoleAnswer {
    const Task *task;
    const char *text;
} HoleAnswer;

// Make a variant of the solution with the content of n holes replaced, each another one; with none
// replaced it is the solution as it is. Returns 0, or -1 after one message.
int session_fill(const Session *session, const char *name, const HoleAnswer answers[], int n,
                 Variant *variant);

// Make a variant of the host files that are handed out, which can be compiled; it has no kernels
// yet. Returns 0, or -1 after one message.
int session_open_kernels(const Session *session, const char *name, Variant *variant);

// Put the kernels of another variant into it. Returns 0, or -1 after one message.
int session_take_kernels(const Session *session, const Variant *from, const Variant *variant);

// What was staged of a submission.
typedef struct StagedFiles {
    int is_complete;                      // each file could be used
    int has_nothing;                      // of the lab that could be used
    int is_replaced[MANIFEST_MAX_FILES];  // this file could not be used
    int n_taken;                          // the others; 0: nothing was replaced
    char *said;  // to the student, or ""; it may quote the submission. Owned by the caller
} StagedFiles;

// Make a variant of what was handed in, with the file as it is handed out in the place of each that
// cannot be used, unless no file can. Returns 0, or -1 after one message.
int session_stage(const Session *session, const char *submission, Variant *variant,
                  StagedFiles *staged);

// The line at which a variant crashed, and its task: see variant_find_line().
char *session_find_line(Session *session, const Variant *variant, const char **task);

// The figure of a variant's race: see variant_race().
double session_race(Session *session, const Variant *variant);

// What a variant that has run answered to the session's job.
Answers variant_answers(const Variant *variant);

// Judge check number i by what a variant that has run did in job number k, and note points, status
// and message. Job 0 is the session's own, those behind it are of the seeds that follow.
void session_judge(Session *session, int k, int i, const Variant *variant, CheckResult *result);

#endif
