// Compiling and running variants side by side, and what the end of each says about it.
#include "variant_steps.h"

#include "crash_line.h"
#include "linker_lines.h"
#include "message.h"
#include "path.h"
#include "probe.h"
#include "race.h"
#include "run_end.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    path_make(path, "%s/variant-%s/out/note", workshop->folder, variant->name);
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
    path_make(path, "%s/variant-%s/out/note", workshop->folder, variant->name);
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
    variant->run_output = strdup(result->output);
    if (result->outcome == SANDBOX_EXITED && result->exit_status == PROBE_EXIT_NO_BUILD &&
        has_only_built(workshop, variant)) {
        variant->build_log = strdup(variant->run_output);
        return;
    }
    variant->trouble = run_end_describe(result, allowed);
    size_t n_bytes;
    if (variant->trouble == NULL &&
        sections_find_any(&variant->answers, PROBE_END, &n_bytes) == NULL) {
        variant->trouble = message_new("it ended by itself, with exit status 0, before it had "
                                       "answered everything: a call of exit()?");
    }
    variant->habits = run_habits_describe(result, variant->is_second && variant->trouble == NULL);
    variant->has_crashed = has_crashed(result);
    if (variant->trouble != NULL) {
        take_place(workshop, variant);
    }
}

// ---- Both steps, side by side ---------------------------------------------------------------

// What a variant may use that runs beside n - 1 others.
static SandboxTime time_allowed(const Variant *variant, Step step, const Allowance *allowance,
                                int n)
{
    return variant->purpose == VARIANT_SOLUTION ? allowance_ours()
                                                : allowance_of(allowance, step, n);
}

static int step_start(const Workshop *workshop, Variant *variant, Step step, SandboxTime allowed)
{
    variant->run = step_sandbox(workshop, variant, step, allowed);
    return variant->run != NULL ? 0 : -1;
}

// Start a step once more, with what is left of the time. Returns 0, or -1 after one message.
static int step_restart(const Workshop *workshop, Variant *variant, Step step, Allowance *allowance,
                        SandboxTime *allowed)
{
    *allowed = time_allowed(variant, step, allowance, 1);
    return step_clear(workshop, variant->name, step) != 0
               ? -1
               : step_start(workshop, variant, step, *allowed);
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

// Wait for a variant's step. It is started again, as long as the deadline leaves time, once where
// the machine had no time for it and once where the driver's compiler gave up on a kernel. Returns
// 0, or -1 after one message when the machinery failed.
static int step_take(const Workshop *workshop, Variant *variant, Step step, SandboxTime allowed,
                     Allowance *allowance)
{
    SandboxResult result;
    const int is_extra = variant->purpose >= VARIANT_CRASH;
    int was_starved = is_extra;
    for (;;) {
        result = sandbox_wait(variant->run);
        variant->run = NULL;
        const int is_starved = result.outcome == SANDBOX_STARVED && !was_starved;
        const int has_fault =
            step == STEP_RUNNING && !variant->is_second && run_end_has_compiler_fault(&result);
        if (!is_starved && !has_fault) {
            break;
        }
        if (has_fault && variant->purpose != VARIANT_SOLUTION) {
            allowance_charge(allowance, &result);
        }
        if (allowance_left(allowance) <= 0) {
            break;
        }
        was_starved |= is_starved;
        variant->is_second |= has_fault;
        free(result.output);
        if (step_restart(workshop, variant, step, allowance, &allowed) != 0) {
            return -1;
        }
    }
    int failed = result.outcome == SANDBOX_FAULT || result.outcome == SANDBOX_STARVED;
    if (failed && is_extra) {
        free(result.output);
        return -1;
    }
    if (result.outcome == SANDBOX_FAULT) {
        fprintf(stderr, "grade: the sandbox failed: %s\n", result.output);
    } else if (result.outcome == SANDBOX_STARVED) {
        fprintf(
            stderr,
            "grade: this machine is too busy: it had %.1f s of processor time for %s in %.0f s; "
            "grade again when it is less so\n",
            result.used.processor, step == STEP_COMPILING ? "compiling" : "running the program",
            result.used.wall);
    } else if (step == STEP_COMPILING) {
        take_build(variant, &result, allowed);
    } else {
        take_answers(workshop, variant, &result, allowed);
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
    return step == STEP_COMPILING ? !variant->is_compiled : variant->build_log == NULL;
}

// Run a step of those variants that need and bear it, side by side.
static int step_run(const Workshop *workshop, Variant *const variants[], int n, Step step,
                    Allowance *allowance)
{
    int result = 0;
    for (int i = 0; i < n; i++) {
        if (is_due(variants[i], step)) {
            const SandboxTime allowed = time_allowed(variants[i], step, allowance, n);
            result |= step_start(workshop, variants[i], step, allowed);
        }
    }
    for (int i = 0; i < n; i++) {
        if (variants[i]->run == NULL) {
            continue;
        }
        // What ours took, ahead of it, may have become known since it was started.
        const SandboxTime allowed = time_allowed(variants[i], step, allowance, n - i);
        sandbox_allow(variants[i]->run, allowed);
        result |= step_take(workshop, variants[i], step, allowed, allowance);
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
