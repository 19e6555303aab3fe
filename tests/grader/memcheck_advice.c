// Offering `make memcheck` (see memcheck_advice.h).
#include "memcheck_advice.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

static int has_kernels(const Manifest *manifest)
{
    for (int i = 0; i < manifest->n_files; i++) {
        if (strstr(manifest->files[i], ".cl") != NULL) {
            return 1;
        }
    }
    return 0;
}

static int is_failed(const CheckResult *check)
{
    return check->status == CHECK_FAILED;
}

static int is_of_pixels(const CheckResult *check)
{
    return check->diagnosis.evidence == EVIDENCE_PICTURE ||
           check->diagnosis.evidence == EVIDENCE_PLAIN_PICTURE;
}

// Was it seen in a scene what is wrong with it?
static int is_recognised(const CheckResult *check)
{
    const Diagnosis *diagnosis = &check->diagnosis;
    return diagnosis->mistake == MISTAKE_UNWRITTEN ||
           diagnosis->evidence == EVIDENCE_PLAIN_PICTURE ||
           (diagnosis->evidence != EVIDENCE_VALUES && check->is_explained);
}

// Are pixels of this task wrong, while all that is asked of its functions is right?
static int has_strange_pixels(const Result *result, const char *task)
{
    int n_strange = 0, n_explained = 0;
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        if (is_failed(check) && strcmp(check->task, task) == 0) {
            n_strange += is_of_pixels(check);
            n_explained += !is_of_pixels(check);
        }
    }
    return n_strange > 0 && n_explained == 0;
}

// Are there pixels, in a task that was answered, of which nothing says why they are wrong?
static int has_unexplained_pixels(const Manifest *manifest, const int *is_untouched,
                                  const Result *result)
{
    int n_strange = 0, n_recognised = 0;
    for (int i = 0; i < result->n_checks; i++) {
        n_recognised += is_failed(&result->checks[i]) && is_recognised(&result->checks[i]);
    }
    for (int t = 0; t < manifest->n_tasks; t++) {
        n_strange += !is_untouched[t] && has_strange_pixels(result, manifest->tasks[t].id);
    }
    return n_strange > 0 && n_recognised == 0;
}

void memcheck_advise(const Manifest *manifest, int crashed, const int *is_untouched, Result *result)
{
    if (!has_kernels(manifest) ||
        (!crashed && !has_unexplained_pixels(manifest, is_untouched, result))) {
        return;
    }
    for (int i = 0; i < result->n_stages; i++) {
        StageResult *stage = &result->stages[i];
        if (strcmp(stage->title, "Running") == 0) {
            char *message = message_new(
                "%s%s%s: `make memcheck LAB=%.2s` looks for indices out of range, "
                "values that were never set and races, at your own lines.",
                stage->message, stage->message[0] != '\0' ? "\n" : "",
                crashed ? "A crash" : "Some pixels are wrong in no usual way", manifest->lab);
            free(stage->message);
            stage->message = message;
        }
    }
}
