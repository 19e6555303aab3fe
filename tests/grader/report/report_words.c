// What the reports for other systems say in words (see report_words.h).
//
// Flow: judging -> result -> REPORTS. Read next: report_gradescope.c.
#include "report_words.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

char *points_words(int points, int max_points)
{
    return message_new("%d of %d points", points, max_points);
}

char *stages_words(const Result *result)
{
    char *words = message_new("%s", "");
    for (int i = 0; i < result->n_stages; i++) {
        const StageResult *stage = &result->stages[i];
        const char *said = stage->message != NULL ? stage->message : "";
        if (stage->status != CHECK_PASSED || said[0] != '\0') {
            const int passed = stage->status == CHECK_PASSED;
            char *longer =
                message_new("%s%s%s:%s%s%s%s", words, words[0] != '\0' ? "\n" : "", stage->title,
                            passed ? "" : " ", passed ? "" : check_status_name(stage->status),
                            said[0] != '\0' ? "\n" : "", said);
            free(words);
            words = longer;
        }
    }
    return words;
}

const char *check_hint(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    const Task *task = manifest_task(manifest, check->task);
    if (check->status != CHECK_FAILED || task == NULL) {
        return "";
    }
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *other = &result->checks[i];
        if (other->status == CHECK_FAILED && other->is_explained &&
            strcmp(other->task, check->task) == 0) {
            return "";
        }
    }
    return manifest_hint(task, check->id);
}

const char *task_hint(const Manifest *manifest, const Result *result, const Task *task)
{
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        if (check->status == CHECK_FAILED && strcmp(check->task, task->id) == 0) {
            return check_hint(manifest, result, check);
        }
    }
    return "";
}

char *check_words(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    const char *message = check->message != NULL ? check->message : "";
    const char *hint = check_hint(manifest, result, check);
    if (check->status == CHECK_NOT_RUN) {
        return message_new("Not run: something before it failed.%s%s",
                           message[0] != '\0' ? "\n" : "", message);
    }
    if (hint[0] == '\0') {
        return message_new("%s", message);
    }
    return message_new("%s%sHint: %s", message, message[0] != '\0' ? "\n" : "", hint);
}

const StageResult *failed_stage(const Result *result)
{
    for (int i = 0; i < result->n_stages; i++) {
        if (result->stages[i].status == CHECK_FAILED) {
            return &result->stages[i];
        }
    }
    return NULL;
}
