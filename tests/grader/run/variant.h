// A variant of a submission: one way to combine files, compiled and run in the workdir.
#ifndef GRADER_VARIANT_H
#define GRADER_VARIANT_H

#include "allowance.h"
#include "run_place.h"
#include "sections.h"
#include "workdir.h"

// What a variant is run for.
typedef enum VariantPurpose {
    VARIANT_JUDGED,    // a submission, or a part of one
    VARIANT_SOLUTION,  // ours, or what runs in its place: what it uses says what others may
    // No points depend on the rest: a busy machine may fail them.
    VARIANT_CRASH,  // built and run with the address sanitizer: see variant_find_line()
    VARIANT_RACE,   // the lab's race runs in the place of its probe: see variant_race()
} VariantPurpose;

typedef struct Variant {
    VariantPurpose purpose;
    char name[80];
    char folder[PATH_MAX];  // in the workdir: in lab/ are its files
    char *build_log;        // set when it does not compile; with the student's file and line; owned
    char *warnings;         // of the compiler, of host files that compile; "" or NULL: none; owned
    char *trouble;          // set when it compiled and did not run to its end: what happened; owned
    ProbeNote note;         // and where, as its probe noted it,
    RunPlace place;         // and in words; all "" when nobody knows
    int has_crashed;        // by a signal, or so that its probe no longer found its job
    int is_endless;         // it used up its time, running or asleep
    char *habits;           // what else there is to say about its run, "" for most; owned
    char *run_output;       // what it wrote to stdout and stderr; owned
    unsigned number;        // of its answers: no other variant has the same
    Sections answers;       // whatever it answered
    Sections further[MAX_FURTHER_JOBS];  // and to the jobs of further seeds
    SandboxRun *run;                     // while it runs
    SandboxTime allowed;                 // what it may use then
    int was_starved;                     // in this step the machine had no time for it once
    int is_left_out;                     // no time was left to begin with it
    int is_compiled;                     // as far as that goes: build_log is set, or it can run
    int is_second;     // its kernels are compiled by SECOND_COMPILER, after a run that ended early
    const char *task;  // whose answer stands in our solution; NULL: a submission, or several
    int is_changed;  // tried alone in files that differ from those handed out in more than answers
    int is_sealed;   // of all answers together: the macro of one ends with it
    const char *alone;     // whose answer is tried alone, with a job of its own; NULL: all of them
    int has_only_kernels;  // tasks of host files are not tried: these are as they are handed out
    int is_told;           // the report says already how and where it ended
} Variant;

// Make the folder of a variant, with the lab's given files in it; put the lab's own files, the ones
// a student hands in, there next. Returns 0, or -1 after one message.
int variant_open(const Workdir *workdir, const char *name, Variant *variant);

// Put one of the lab's own files there. Takes the text over; NULL, of which something was said
// already, is a failure, too. Returns 0, or -1 after one message.
int variant_put(const Variant *variant, const char *file, char *text);

// Its path, there or not.
void variant_file(const Variant *variant, const char *file, char path[PATH_MAX]);

// Forget what came of a variant of which nothing is judged yet, so that it can be compiled and run
// anew. Returns 0, or -1 after one message.
int variant_reset(Variant *variant);

// Where the job of a variant that is tried alone is to be written before it runs.
void variant_job_path(const Variant *variant, char path[PATH_MAX]);

// Compile n variants side by side, each for as long as is allowed. What is ours must come first:
// what it uses is noted, and from then on that is what limits the others. One that the machine was
// too busy for is tried again. Of one submission's own, at most two run at a time, in this order,
// and those for which nothing is left are left out. Returns 0, or -1 after one message when the
// machinery failed.
int variants_compile(const Workdir *workdir, Variant *const variants[], int n,
                     Allowance *allowance);

// Likewise compile those that are not yet, and run all.
int variants_run(const Workdir *workdir, Variant *const variants[], int n, Allowance *allowance);

// After a crash of a lab with host files: compile and run it once more, with the address sanitizer,
// and say at which line of the student's and by what it came about, "render.c:12: ..." and the line
// itself. Owned by the caller; NULL where that finds nothing. `task` receives the task whose line
// it is, or NULL. What a student's program prints can decide the number of the line and which of
// our words are said of it. The answers stay.
char *variant_find_line(const Workdir *workdir, const Variant *variant, Allowance *allowance,
                        const char **task);

// Of a lab with a leaderboard, whose answers are kernels: let the variant's draw once more, beside
// a reference. Returns its figure (race.h), or 0 where there is none. The answers stay.
double variant_race(const Workdir *workdir, const Variant *variant, Allowance *allowance);

void variant_free(Variant *variant);

#endif
