// Compiling and running variants side by side, and what the end of each says about it.
#include "variant_steps.h"

#include "crash_line.h"
#include "linker_lines.h"
#include "message.h"
#include "path.h"
#include "probe.h"
#include "progress.h"
#include "race.h"
#include "run_end.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

// Answers are pictures of at most 336x240 pixels of 16 bytes, a dozen of them: far below this.
#define MAX_ANSWER_BYTES ((size_t)FILE_MB << 20)

// Why the compiler came to no end of its own.
static char *describe_compiler_end(const SandboxResult *result, SandboxTime allowed)
{
    if (result->outcome == SANDBOX_TIMED_OUT) {
        return message_new("the compiler did not finish in time: it used up the %.1f s of "
                           "processor time that are allowed; too large a program?",
                           allowed.processor);
    }
    char *end = run_end_describe(result, allowed);
    char *message = message_new("the compiler did not finish: %s", end);
    free(end);
    return message;
}

// What a compiler's end says about the variant.
static void take_build(Variant *variant, SandboxResult *result, SandboxTime allowed)
{
    variant->is_compiled = 1;
    if (result->outcome != SANDBOX_EXITED) {
        variant->build_log = describe_compiler_end(result, allowed);
        return;
    }
    linker_lines_shorten(result->output);
    *(result->exit_status != 0 ? &variant->build_log : &variant->warnings) = result->output;
    result->output = NULL;
}

// Had it done nothing yet but build its kernels, so that their compiler may have failed? The
// student's functions end with any exit status they like: believed is who has none of them behind.
static int has_only_built(const Workshop *workshop, const Variant *variant)
{
    char path[PATH_MAX];
    path_make(path, "%s/variant-%s/out", workshop->folder, variant->name);
    const ProbeNote note = run_note_load(path);
    const char *name;
    size_t place = 0, n_bytes;
    return manifest_has_kernels(workshop->manifest) &&
           strncmp(note.name, PROBE_NOTE_BUILD, sizeof note.name) == 0 &&
           sections_next(&variant->answers, &place, &name, &n_bytes) != NULL &&
           strncmp(name, PROBE_DEVICE, SECTION_NAME_BYTES) == 0 &&
           sections_next(&variant->answers, &place, &name, &n_bytes) == NULL;
}

// Where the probe says it was: nothing of it is shown of an answer alone.
static void take_place(const Workshop *workshop, Variant *variant)
{
    char path[PATH_MAX];
    path_make(path, "%s/variant-%s/out", workshop->folder, variant->name);
    if (variant->alone == NULL) {
        variant->note = run_note_load(path);
        variant->place = run_place_before(&variant->note);
    }
}

static void take_further_answers(const Workshop *workshop, Variant *variant)
{
    for (int i = 0; i < workshop->n_further_jobs && variant->alone == NULL; i++) {
        char suffix[16], path[PATH_MAX];
        workshop_job_suffix(i + 1, suffix);
        path_make(path, "%s/variant-%s/out/answers%s", workshop->folder, variant->name, suffix);
        sections_load(path, MAX_ANSWER_BYTES, &variant->further[i]);
    }
}

// Has the program damaged memory? A signal says so, or the probe, which no longer finds its job.
static int has_crashed(const SandboxResult *result)
{
    return (result->outcome == SANDBOX_CRASHED && result->signal != SIGXFSZ &&
            result->signal != SIGKILL) ||
           (result->outcome == SANDBOX_EXITED && result->exit_status == PROBE_EXIT_FAULT);
}

// What a probe's end and answers say about the variant.
static void take_answers(const Workshop *workshop, Variant *variant, SandboxResult *result,
                         SandboxTime allowed)
{
    char path[PATH_MAX];
    path_make(path, "%s/variant-%s/out/answers", workshop->folder, variant->name);
    sections_load(path, MAX_ANSWER_BYTES, &variant->answers);
    take_further_answers(workshop, variant);
    char *first_output = variant->run_output;  // NULL where there was no other try
    variant->run_output = strdup(result->output);
    if (result->outcome == SANDBOX_EXITED && result->exit_status == PROBE_EXIT_NO_BUILD &&
        has_only_built(workshop, variant)) {
        variant->build_log = strdup(variant->run_output);
        free(first_output);
        return;
    }
    variant->trouble = run_end_of_probe(result, allowed, &variant->answers);
    if (variant->trouble != NULL && first_output != NULL) {
        // A driver that knows no second way says so, which is no news.
        free(variant->run_output);
        variant->run_output = first_output;
    } else {
        free(first_output);
    }
    variant->habits = run_habits_describe(result, variant->is_second && variant->trouble == NULL);
    variant->has_crashed = has_crashed(result);
    variant->is_endless = result->outcome == SANDBOX_TIMED_OUT || result->outcome == SANDBOX_ASLEEP;
    if (variant->trouble != NULL) {
        take_place(workshop, variant);
    }
}

// ---- Both steps, side by side ---------------------------------------------------------------

// So many runs of one submission at a time: a grader has two processors for it at most.
enum { SIDE_BY_SIDE = 2 };

// How often is looked whether a run has ended.
static const struct timespec pause_between_looks = {.tv_nsec = 10 * 1000 * 1000};

// Let a variant use what it may beside n - 1 others, also while it runs.
static void time_allow(Variant *variant, Step step, const Allowance *allowance, int n)
{
    variant->allowed = variant->purpose == VARIANT_SOLUTION
                           ? allowance_ours()
                           : allowance_of(allowance, step, n, variant->is_again);
    if (variant->run != NULL) {
        sandbox_allow(variant->run, variant->allowed);
    }
}

static int step_start(const Workshop *workshop, Variant *variant, Step step)
{
    variant->run = step_sandbox(workshop, variant, step, variant->allowed);
    return variant->run != NULL ? 0 : -1;
}

// Start a step once more, with what is left of the time. Returns 0, or -1 after one message.
static int step_restart(const Workshop *workshop, Variant *variant, Step step,
                        const Allowance *allowance)
{
    time_allow(variant, step, allowance, 1);
    return step_clear(workshop, variant->name, step) != 0 ? -1
                                                          : step_start(workshop, variant, step);
}

// Remove what a run wrote, as soon as it is read, and a program that nobody starts again: the next
// run, or our own files, may need the room, which may be memory.
static void step_files_remove(const Workshop *workshop, const Variant *variant)
{
    if (variant->purpose != VARIANT_CRASH) {
        step_folder_remove(workshop, variant->name, STEP_RUNNING);
    }
    if (variant->alone != NULL) {
        step_folder_remove(workshop, variant->name, STEP_COMPILING);
    }
}

// Must a run that has ended be tried again, because the machine had no time for it, or because the
// driver's compiler may have given up on a kernel? Each of these counts once, and as long as time
// is left.
static int step_is_repeated(const Workshop *workshop, Variant *variant, Step step,
                            const SandboxResult *result, Allowance *allowance)
{
    const int is_starved = result->outcome == SANDBOX_STARVED && !variant->was_starved &&
                           variant->purpose < VARIANT_CRASH;
    const int may_be_compilers =
        step == STEP_RUNNING && !variant->is_second && manifest_has_kernels(workshop->manifest) &&
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
static int step_take(const Workshop *workshop, Variant *variant, Step step, Allowance *allowance)
{
    SandboxResult result = sandbox_wait(variant->run);
    variant->run = NULL;
    if (step_is_repeated(workshop, variant, step, &result, allowance)) {
        if (variant->is_second && variant->run_output == NULL) {
            variant->run_output = result.output;  // of the first try
        } else {
            free(result.output);
        }
        return step_restart(workshop, variant, step, allowance);
    }
    const int failed = result.outcome == SANDBOX_FAULT || result.outcome == SANDBOX_STARVED;
    if (failed && variant->purpose >= VARIANT_CRASH) {
        free(result.output);
        return -1;
    }
    if (failed) {
        complain_of(&result, step);
    } else if (step == STEP_COMPILING) {
        take_build(variant, &result, variant->allowed);
    } else {
        take_answers(workshop, variant, &result, variant->allowed);
        step_files_remove(workshop, variant);
    }
    if (!failed && variant->purpose == VARIANT_SOLUTION) {
        allowance_note(allowance, step, result.used);
    } else if (variant->purpose != VARIANT_SOLUTION) {
        allowance_charge(allowance, &result);
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
static int step_begin(const Workshop *workshop, Variant *variant, Step step,
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
    time_allow(variant, step, allowance, 1);
    return step_start(workshop, variant, step);
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
static int yardstick_run(const Workshop *workshop, Allowance *allowance)
{
    Variant *const variants[] = {allowance->yardstick};
    allowance->yardstick = NULL;
    return variants_run(workshop, variants, 1, allowance);
}

// Run a step of those variants that need and bear it, side by side.
static int step_run(const Workshop *workshop, Variant *const variants[], int n, Step step,
                    Allowance *allowance)
{
    const int most = allowance->is_for_one ? SIDE_BY_SIDE : n;
    int result = 0, n_running = 0;
    for (int next = 0; next < n || n_running > 0;) {
        if (next < n && n_running < most) {
            result |= step_begin(workshop, variants[next++], step, allowance);
        } else {
            // What ours took, or who runs beside, may have changed since they were started.
            for (int i = 0; i < n; i++) {
                if (variants[i]->run != NULL) {
                    time_allow(variants[i], step, allowance, n_running);
                }
            }
            const int ended = any_wait(variants, n, step, allowance);
            result |= ended < 0 ? yardstick_run(workshop, allowance)
                                : step_take(workshop, variants[ended], step, allowance);
        }
        n_running = count_running(variants, n);
    }
    return result;
}

int variants_compile(const Workshop *workshop, Variant *const variants[], int n,
                     Allowance *allowance)
{
    return workshop->needs_compiler ? step_run(workshop, variants, n, STEP_COMPILING, allowance)
                                    : 0;
}

int variants_run(const Workshop *workshop, Variant *const variants[], int n, Allowance *allowance)
{
    return variants_compile(workshop, variants, n, allowance) != 0
               ? -1
               : step_run(workshop, variants, n, STEP_RUNNING, allowance);
}

// ---- The line of a crash ------------------------------------------------------------------------

char *variant_find_line(const Workshop *workshop, const Variant *variant, Allowance *allowance,
                        const char **task)
{
    char out[PATH_MAX], lab[PATH_MAX];
    Variant checked = {.purpose = VARIANT_CRASH};
    Variant *const variants[] = {&checked};
    memcpy(checked.name, variant->name, sizeof checked.name);
    *task = NULL;
    if (!workshop->needs_compiler || step_clear(workshop, variant->name, STEP_COMPILING) != 0 ||
        step_clear(workshop, variant->name, STEP_RUNNING) != 0 ||
        variants_run(workshop, variants, 1, allowance) != 0) {
        return NULL;
    }
    path_make(out, "%s/variant-%s/out", workshop->folder, variant->name);
    path_make(lab, "%s/variant-%s/lab", workshop->folder, variant->name);
    char *line =
        checked.trouble != NULL ? crash_line_find(out, lab, workshop->manifest, task) : NULL;
    step_folder_remove(workshop, variant->name, STEP_RUNNING);
    variant_free(&checked);
    return line;
}

// ---- A race -------------------------------------------------------------------------------------

double variant_race(const Workshop *workshop, const Variant *variant, Allowance *allowance)
{
    double figure = 0;
    Variant race = {.purpose = VARIANT_RACE};
    Variant *const variants[] = {&race};
    memcpy(race.name, variant->name, sizeof race.name);
    if (step_clear(workshop, variant->name, STEP_RUNNING) == 0 &&
        step_run(workshop, variants, 1, STEP_RUNNING, allowance) == 0 && race.build_log == NULL &&
        race.trouble == NULL) {
        figure = race_judge(&race.answers);
    }
    variant_free(&race);
    return figure;
}
