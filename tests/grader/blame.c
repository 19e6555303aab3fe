// Finding whose fault it is that a check failed (see blame.h).
//
// Flow: judged -> BLAMED -> result -> reports. Called by grade.c. Read next: report_words.c.
#include "blame.h"

#include "message.h"

#include <stdlib.h>
#include <string.h>

// Of the failed checks that look at less than this one does, and are not others' fault, the first
// of those that look at least; with `task` only that task's. NULL when there is none.
static const Check *narrower_fault(const Check *checks, const Result *result, int check,
                                   const char *task)
{
    for (CheckScope scope = IS_OWN; scope < checks[check].scope; scope++) {
        for (int i = 0; i < result->n_checks; i++) {
            const Check *other = &checks[i];
            const CheckResult *found = &result->checks[i];
            if (other->scope == scope && found->status == CHECK_FAILED &&
                (task == NULL || strcmp(other->task, task) == 0)) {
                return other;
            }
        }
    }
    return NULL;
}

// What a check found comes of another task's answer, too. Where it fails alone as well, only the
// cause that it names is in doubt; where nobody could try that, it waits.
static void pass_blame(CheckResult *check, const char *task)
{
    const char *cause = strstr(check->message, MESSAGE_CAUSE);
    const size_t length = cause ? (size_t)(cause - check->message) : strlen(check->message);
    char *message =
        check->is_own ? message_new("%.*s" MESSAGE_CAUSE "%s is wrong, too, and has a part in this",
                                    (int)length, check->message, task)
                      : message_new("waits for %s, which it needs and whose own checks fail", task);
    free(check->message);
    check->message = message;
    check->is_explained = 0;
    check->status = check->is_own ? CHECK_FAILED : CHECK_NOT_RUN;
}

// Blame others for the failed checks of one scope.
static void blame_in_scope(const Check *checks, Result *result, CheckScope scope)
{
    for (int i = 0; i < result->n_checks; i++) {
        CheckResult *check = &result->checks[i];
        const Check *culprit = narrower_fault(checks, result, i, NULL);
        if (checks[i].scope == scope && check->status == CHECK_FAILED && culprit != NULL &&
            narrower_fault(checks, result, i, check->task) == NULL) {
            pass_blame(check, culprit->task);
        }
    }
}

void blame_others(const Check *checks, Result *result)
{
    for (CheckScope scope = IS_CALLER; scope <= IS_WHOLE; scope++) {
        blame_in_scope(checks, result, scope);
    }
}
