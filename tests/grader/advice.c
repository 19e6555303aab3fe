// What a report offers to try next (see advice.h).
//
// Called by grade.c. Read next: tests/memcheck/README.md.
#include "advice.h"

#include "message.h"
#include "path.h"
#include "source_words.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// Did it fail, and may students see how?
static int is_failed(const CheckResult *check)
{
    return check->status == CHECK_FAILED && check_shows(check);
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
            n_strange += check_is_of_pixels(check);
            n_explained += !check_is_of_pixels(check);
        }
    }
    return n_strange > 0 && n_explained == 0;
}

// Is this a counter that stays below its bound, as in `i < n`?
static int is_counter(const SourceWord *words, int n_words, const SourceWord *name)
{
    int n_below = 0, n_others = 0;
    for (int i = 0; i + 1 < n_words; i++) {
        if (source_is(&words[i], SOURCE_NAME, name->text)) {
            n_below += source_is(&words[i + 1], SOURCE_SIGN, "<");
            n_others += source_is(&words[i + 1], SOURCE_SIGN, "<=");
        }
    }
    return name->kind == SOURCE_NAME && n_below > 0 && n_others == 0;
}

// Do three words declare something and set nothing: `float minDepth;`, `float red, green;`?
static int declares_unset(const SourceWord words[3])
{
    return words[0].kind == SOURCE_NAME && words[1].kind == SOURCE_NAME &&
           !source_is_one_of(&words[0], "return goto else case") && words[2].kind == SOURCE_SIGN &&
           source_is_one_of(&words[2], "; ,");
}

// Is there anything in an answer in which memcheck could find a fault: an index that is no such
// counter, or a variable without a value?
static int may_misuse_memory(const char *answer)
{
    int n_words = 0, n_found = 0;
    SourceWord *words = source_words(answer, &n_words);
    for (int i = 0; words != NULL && i + 2 < n_words; i++) {
        const int is_index = source_is(&words[i], SOURCE_SIGN, "[");
        n_found += (is_index && !(source_is(&words[i + 2], SOURCE_SIGN, "]") &&
                                  is_counter(words, n_words, &words[i + 1]))) ||
                   declares_unset(&words[i]);
    }
    free(words);
    return n_found > 0;
}

// The task whose pixels are wrong, while nothing says why, and whose answer may misuse memory, or
// NULL.
static const Task *find_strange_task(const Manifest *manifest, const char *const answers[],
                                     const Result *result)
{
    for (int i = 0; i < result->n_checks; i++) {
        if (is_failed(&result->checks[i]) && is_recognised(&result->checks[i])) {
            return NULL;
        }
    }
    for (int t = 0; t < manifest->n_tasks; t++) {
        const Task *task = &manifest->tasks[t];
        if (answers[t] != NULL && has_strange_pixels(result, task->id) &&
            may_misuse_memory(answers[t])) {
            return task;
        }
    }
    return NULL;
}

// `what` happened, and memcheck looks for its cause.
static char *offer_memcheck(const Manifest *manifest, const char *what)
{
    return message_new(
        "%s: `make memcheck LAB=%.2s` looks for indices out of range and values that "
        "were never set, at your own lines.",
        what, manifest->lab);
}

char *advice_after_crash(const Manifest *manifest)
{
    return offer_memcheck(manifest, "A crash");
}

// The line of the first word `local` in a kernel's source, or 0.
static int local_line(const char *source)
{
    SourceReader reader = source_reader(source);
    SourceWord word;
    do {
        word = source_next(&reader);
    } while (word.kind != SOURCE_END &&
             !(word.kind == SOURCE_NAME && source_is_one_of(&word, "local __local")));
    return word.kind == SOURCE_END ? 0 : word.line;
}

char *advice_on_local(const Manifest *manifest, const char *folder)
{
    for (int i = 0; i < manifest->n_files; i++) {
        const char *name = manifest->files[i];
        char path[PATH_MAX];
        path_make(path, "%s/%s", folder, name);
        const int is_kernel = !manifest_is_host_file(name) && access(path, R_OK) == 0;
        char *source = is_kernel ? text_file_read(path) : NULL;
        const int line = source != NULL ? local_line(source) : 0;
        free(source);
        if (line > 0) {
            return message_new("%s:%d: all work-items of a group share a `local` variable, also "
                               "where this device let them take turns.",
                               name, line);
        }
    }
    return NULL;
}

char *advice_on_pixels(const Manifest *manifest, const char *const answers[], const Result *result)
{
    const Task *task =
        manifest_has_kernels(manifest) ? find_strange_task(manifest, answers, result) : NULL;
    if (task == NULL) {
        return NULL;
    }
    char *what = message_new("Some pixels are wrong in no usual way, and %s has an index that may "
                             "leave its array, or a variable that is declared without a value",
                             task->id);
    char *advice = offer_memcheck(manifest, what);
    free(what);
    return advice;
}
