// Compiling and running variants side by side (see variant.h).
//
// A step of a variant goes from function to function in one direction: step_begin(), step_start(),
// any_wait(), step_take(); from there back to step_start() once, if the machine or the driver's
// compiler may be at fault. Read next: variant_end.c, which says what an end means.
#include "variant_steps.h"

#include "crash_line.h"
#include "path.h"
#include "progress.h"
#include "race.h"
#include "run_end.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

// So many runs of one submission at a time: a grader has two processors for it at most.
enum { SIDE_BY_SIDE = 2 };

// How often is looked whether a run has ended.
static const struct timespec pause_between_looks = {.tv_nsec = 10 * 1000 * 1000};

// May it have the endless loop that the whole has met? Then less time is enough to see it again.
// Where that is known to be another task's, it gets the time of any first run.
static int may_loop_again(const Variant *variant, const Allowance *allowance)
{
    const char *task = allowance->endless_task;
    return allowance->is_endless &&
           (variant->alone == NULL || task == NULL || strcmp(task, variant->alone) == 0);
}

// Let a variant use what it may beside n - 1 others, also while it runs.
static void time_allow(Variant *variant, Step step, const Allowance *allowance, int n)
{
    variant->allowed = variant->purpose == VARIANT_SOLUTION
                           ? allowance_ours()
                           : allowance_of(allowance, step, n, may_loop_again(variant, allowance));
    if (variant->run != NULL) {
        sandbox_allow(variant->run, variant->allowed);
    }
}

// Start a step, for the first time or, with what is left of the time, once more. Returns 0, or -1
// after one message.
static int step_start(const Workdir *workdir, Variant *variant, Step step,
                      const Allowance *allowance)
{
    time_allow(variant, step, allowance, 1);
    variant->run = step_sandbox(workdir, variant, step, variant->allowed);
    return variant->run != NULL ? 0 : -1;
}

// Remove what a run wrote, as soon as it is read, and a program that nobody starts again: the next
// run, or our own files, may need the room, which may be memory.
static void step_files_remove(const Variant *variant, Step step)
{
    if (step == STEP_RUNNING && variant->purpose != VARIANT_CRASH) {
        step_folder_remove(variant, STEP_RUNNING);
    }
    if (step == STEP_RUNNING && variant->alone != NULL) {
        step_folder_remove(variant, STEP_COMPILING);
    }
}

// Must a run that has ended be tried again, because the machine had no time for it, or because the
// driver's compiler may have given up on a kernel? Each of these counts once, and as long as time
// is left.
static int step_is_repeated(const Workdir *workdir, Variant *variant, Step step,
                            const SandboxResult *result, Allowance *allowance)
{
    const int is_starved = result->outcome == SANDBOX_STARVED && !variant->was_starved &&
                           variant->purpose < VARIANT_CRASH;
    const int may_be_compilers =
        step == STEP_RUNNING && !variant->is_second && manifest_has_kernels(workdir->manifest) &&
        variant->purpose != VARIANT_CRASH && run_end_is_as_compilers(result);
    if ((!is_starved && !may_be_compilers) || allowance_left(allowance) <= 0) {
        return 0;
    }
    if (may_be_compilers && variant->purpose != VARIANT_SOLUTION) {
        allowance_charge(allowance, result);
    }
    variant->was_starved |= is_starved;
    variant->is_second |= may_be_compilers;
    return 1;
}

// Say why the machinery failed.
static void complain_of(const SandboxResult *result, Step step)
{
    if (result->outcome == SANDBOX_FAULT) {
        fprintf(stderr, "grade: the sandbox failed: %s\n", result->output);
        return;
    }
    fprintf(stderr,
            "grade: this machine is too busy: it had %.1f s of processor time for %s in %.0f s; "
            "grade again when it is less so\n",
            result->used.processor, step == STEP_COMPILING ? "compiling" : "running the program",
            result->used.wall);
}

// Take what came of a variant's step, which has ended, or start it again. Returns 0, or -1 after
// one message when the machinery failed.
static int step_take(const Workdir *workdir, Variant *variant, Step step, Allowance *allowance)
{
    SandboxResult result = sandbox_wait(variant->run);
    const int failed = result.outcome == SANDBOX_FAULT || result.outcome == SANDBOX_STARVED;
    variant->run = NULL;
    if (step_is_repeated(workdir, variant, step, &result, allowance)) {
        if (variant->is_second && variant->run_output == NULL) {
            variant->run_output = result.output;  // of the first try
        } else {
            free(result.output);
        }
        return step_folder_make(variant, step) != 0 ? -1
                                                    : step_start(workdir, variant, step, allowance);
    }
    if (failed && variant->purpose < VARIANT_CRASH) {
        complain_of(&result, step);
    } else if (!failed) {
        step_end_take(workdir, variant, step, &result);
        step_files_remove(variant, step);
        if (variant->purpose == VARIANT_SOLUTION) {
            allowance_note(allowance, step, result.used);
        } else {
            allowance_charge(allowance, &result);
        }
    }
    free(result.output);
    return failed ? -1 : 0;
}

static int is_due(const Variant *variant, Step step)
{
    return !variant->is_left_out &&
           (step == STEP_COMPILING ? !variant->is_compiled : variant->build_log == NULL);
}

// Begin a step of a variant that needs and bears it, as long as the submission has time. Returns 0,
// or -1 after one message.
static int step_begin(const Workdir *workdir, Variant *variant, Step step,
                      const Allowance *allowance)
{
    if (!is_due(variant, step)) {
        return 0;
    }
    if (allowance->is_for_one && allowance_left(allowance) <= 0) {
        variant->is_left_out = 1;
        return 0;
    }
    variant->was_starved = 0;
    return step_start(workdir, variant, step, allowance);
}

// Tell what is done: of several, the first.
static void say_what_runs(const Variant *variant, Step step, int number, int n)
{
    if (variant->alone != NULL) {
        progress_say("checking %s alone: task %d of %d", variant->alone, number, n);
    } else if (variant->purpose == VARIANT_CRASH) {
        progress_say("looking for the line of the crash");
    } else if (variant->purpose == VARIANT_RACE) {
        progress_say("measuring how fast it is");
    } else if (variant->purpose == VARIANT_SOLUTION && number == n) {
        progress_say("measuring how much time this machine needs");
    } else {
        progress_say(step == STEP_COMPILING ? "compiling" : "running your program");
    }
}

// Wait until one of those that run has ended. Returns its number; or -1 if one runs for so long
// that it must be known first what it may use.
static int any_wait(Variant *const variants[], int n, Step step, const Allowance *allowance)
{
    int first = 0;
    while (variants[first]->run == NULL) {
        first++;
    }
    say_what_runs(variants[first], step, first + 1, n);
    for (;;) {
        for (int i = 0; i < n; i++) {
            if (variants[i]->run != NULL && sandbox_has_ended(variants[i]->run)) {
                progress_hide();
                return i;
            }
            if (variants[i]->run != NULL &&
                allowance_is_asked(allowance, sandbox_used(variants[i]->run))) {
                return -1;
            }
        }
        progress_show();
        nanosleep(&pause_between_looks, NULL);
    }
}

static int count_running(Variant *const variants[], int n)
{
    int n_running = 0;
    for (int i = 0; i < n; i++) {
        n_running += variants[i]->run != NULL;
    }
    return n_running;
}

// Where the solution is not here: run what runs in its place, beside all that runs already. Returns
// 0, or -1 after one message.
static int yardstick_run(const Workdir *workdir, Allowance *allowance)
{
    Variant *const variants[] = {allowance->yardstick};
    allowance->yardstick = NULL;
    return variants_run(workdir, variants, 1, allowance);
}

// Run a step of those variants that need and bear it, side by side.
static int step_run(const Workdir *workdir, Variant *const variants[], int n, Step step,
                    Allowance *allowance)
{
    const int most = allowance->is_for_one ? SIDE_BY_SIDE : n;
    int result = 0, n_running = 0;
    for (int next = 0; next < n || n_running > 0;) {
        if (next < n && n_running < most) {
            result |= step_begin(workdir, variants[next++], step, allowance);
        } else {
            // What ours took, or who runs beside, may have changed since they were started.
            for (int i = 0; i < n; i++) {
                if (variants[i]->run != NULL) {
                    time_allow(variants[i], step, allowance, n_running);
                }
            }
            const int ended = any_wait(variants, n, step, allowance);
            result |= ended < 0 ? yardstick_run(workdir, allowance)
                                : step_take(workdir, variants[ended], step, allowance);
        }
        n_running = count_running(variants, n);
    }
    return result;
}

int variants_compile(const Workdir *workdir, Variant *const variants[], int n, Allowance *allowance)
{
    return workdir->needs_compiler ? step_run(workdir, variants, n, STEP_COMPILING, allowance) : 0;
}

int variants_run(const Workdir *workdir, Variant *const variants[], int n, Allowance *allowance)
{
    return variants_compile(workdir, variants, n, allowance) != 0
               ? -1
               : step_run(workdir, variants, n, STEP_RUNNING, allowance);
}

// ---- Once more ----------------------------------------------------------------------------------

// A variant of the same files for another purpose. Returns 0, or -1 after one message.
static int variant_repeat(const Variant *variant, VariantPurpose purpose, Variant *again)
{
    *again = (Variant){.purpose = purpose};
    memcpy(again->name, variant->name, sizeof again->name);
    memcpy(again->folder, variant->folder, sizeof again->folder);
    return step_folder_make(again, STEP_RUNNING);
}

char *variant_find_line(const Workdir *workdir, const Variant *variant, Allowance *allowance,
                        const char **task)
{
    char out[PATH_MAX], lab[PATH_MAX], *line = NULL;
    Variant checked = {0};
    Variant *const variants[] = {&checked};
    *task = NULL;
    if (workdir->needs_compiler && variant_repeat(variant, VARIANT_CRASH, &checked) == 0 &&
        step_folder_make(&checked, STEP_COMPILING) == 0 &&
        variants_run(workdir, variants, 1, allowance) == 0 && checked.trouble != NULL) {
        path_make(out, "%s/out", variant->folder);
        path_make(lab, "%s/lab", variant->folder);
        line = crash_line_find(out, lab, workdir->manifest, task);
    }
    step_folder_remove(variant, STEP_RUNNING);
    variant_free(&checked);
    return line;
}

double variant_race(const Workdir *workdir, const Variant *variant, Allowance *allowance)
{
    double figure = 0;
    Variant race;
    Variant *const variants[] = {&race};
    if (variant_repeat(variant, VARIANT_RACE, &race) == 0 &&
        step_run(workdir, variants, 1, STEP_RUNNING, allowance) == 0 && race.build_log == NULL &&
        race.trouble == NULL) {
        figure = race_judge(&race.answers);
    }
    variant_free(&race);
    return figure;
}
