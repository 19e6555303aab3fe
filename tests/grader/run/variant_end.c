// What the end of a variant's step says about it (see variant_steps.h).
//
// Read next: run_end.c, which has the words.
#include "linker_lines.h"
#include "message.h"
#include "path.h"
#include "probe.h"
#include "run_end.h"
#include "variant_steps.h"

#include <signal.h>
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
static void take_build(Variant *variant, SandboxResult *result)
{
    variant->is_compiled = 1;
    if (result->outcome != SANDBOX_EXITED) {
        variant->build_log = describe_compiler_end(result, variant->allowed);
        return;
    }
    linker_lines_shorten(result->output);
    *(result->exit_status != 0 ? &variant->build_log : &variant->warnings) = result->output;
    result->output = NULL;
}

// Had it done nothing yet but build its kernels, so that their compiler may have failed? The
// student's functions end with any exit status they like: believed is who has none of them behind.
static int has_only_built(const Variant *variant, const ProbeNote *note)
{
    const char *name;
    size_t place = 0, n_bytes;
    return strncmp(note->name, PROBE_NOTE_BUILD, sizeof note->name) == 0 &&
           sections_next(&variant->answers, &place, &name, &n_bytes) != NULL &&
           strncmp(name, PROBE_DEVICE, SECTION_NAME_BYTES) == 0 &&
           sections_next(&variant->answers, &place, &name, &n_bytes) == NULL;
}

// Load what it answered to all jobs: of a submission as a whole there may be further ones.
static void take_files(const Workdir *workdir, Variant *variant)
{
    const int n_further = variant->alone == NULL ? workdir->n_further_jobs : 0;
    char path[PATH_MAX], suffix[16];
    for (int job = 0; job <= n_further; job++) {
        workdir_job_suffix(job, suffix);
        path_make(path, "%s/out/answers%s", variant->folder, suffix);
        sections_load(path, MAX_ANSWER_BYTES,
                      job == 0 ? &variant->answers : &variant->further[job - 1]);
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
static void take_answers(const Workdir *workdir, Variant *variant, const SandboxResult *result)
{
    char out[PATH_MAX];
    char *first_output = variant->run_output;  // NULL where there was no other try
    path_make(out, "%s/out", variant->folder);
    take_files(workdir, variant);
    variant->run_output = strdup(result->output);
    variant->trouble = run_end_of_probe(result, variant->allowed, &variant->answers);
    const ProbeNote note = variant->trouble != NULL ? run_note_load(out) : (ProbeNote){0};
    if (result->outcome == SANDBOX_EXITED && result->exit_status == PROBE_EXIT_NO_BUILD &&
        manifest_has_kernels(workdir->manifest) && has_only_built(variant, &note)) {
        variant->build_log = strdup(variant->run_output);
        free(variant->trouble);
        variant->trouble = NULL;
        free(first_output);
        return;
    }
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
    if (variant->trouble != NULL && variant->alone == NULL) {  // of one alone nothing is shown
        variant->note = note;
        variant->place = run_place_before(&note);
    }
}

void step_end_take(const Workdir *workdir, Variant *variant, Step step, SandboxResult *result)
{
    if (step == STEP_COMPILING) {
        take_build(variant, result);
    } else {
        take_answers(workdir, variant, result);
    }
}
