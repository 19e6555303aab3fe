// The hints that stand below what failed (see hints.h).
//
// Read next: report_text.c.
#include "hints.h"

#include <string.h>

const char *check_hint(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    const Task *task = manifest_task(manifest, check->task);
    if (check->status != CHECK_FAILED || !check_shows(check) || task == NULL ||
        check->is_explained) {
        return "";
    }
    // Where another check has named the task's mistake, the hint is about that.
    const char *id = check->id;
    for (int i = result->n_checks - 1; i >= 0; i--) {
        const CheckResult *other = &result->checks[i];
        if (other->status == CHECK_FAILED && other->diagnosis.cause != NULL && check_shows(other) &&
            strcmp(other->task, check->task) == 0) {
            id = other->id;
        }
    }
    return manifest_hint(task, id);
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
