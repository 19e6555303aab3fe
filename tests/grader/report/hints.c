// The hints that stand below what failed (see hints.h).
//
// Read next: report_text.c.
#include "hints.h"

#include <string.h>

const char *check_hint(const Manifest *manifest, const Result *result, const CheckResult *check)
{
    const Task *task = manifest_task(manifest, check->task);
    if (check->status != CHECK_FAILED || !check_shows(check) || task == NULL) {
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
