// Finding whose fault it is that a check failed (see blame.h).
//
// Called by grade.c. Read next: hints.c.
#include "blame.h"

#include "message.h"

#include <string.h>

int check_needs(const Check *check, const char *task)
{
    const size_t length = strlen(task);
    for (const char *id = check->needs; id != NULL && *id != '\0'; id += strspn(id, " ")) {
        const size_t n = strcspn(id, " ");
        if ((n == 1 && *id == '*') || (n == length && strncmp(id, task, n) == 0)) {
            return 1;
        }
        id += n;
    }
    return 0;
}

int check_needs_others(const Check *check)
{
    return check->needs != NULL && check->needs[0] != '\0';
}

// Is it certain that this check failed by its own task's answer?
static int is_fault(const Check *check, const CheckResult *found)
{
    return found->status == CHECK_FAILED &&
           (found->is_own || found->is_unanswered || !check_needs_others(check));
}

// The first task that check number i needs and whose answer is wrong for certain, or NULL. A check
// that could not be tried alone is its own task's fault where another check of it is.
static const char *culprit_of(const Check *checks, const Result *result, int i)
{
    const char *culprit = NULL;
    for (int j = 0; j < result->n_checks; j++) {
        const int is_own_task = strcmp(checks[j].task, checks[i].task) == 0;
        const CheckResult *found = &result->checks[j];
        if (is_own_task && !result->checks[i].is_own && is_fault(&checks[j], found)) {
            return NULL;
        }
        if (culprit == NULL && !is_own_task && check_needs(&checks[i], checks[j].task) &&
            is_fault(&checks[j], found)) {
            culprit = checks[j].task;
        }
    }
    return culprit;
}

// The same facts with another task for their cause; what the cause named goes with it.
static Diagnosis with_culprit(const Diagnosis *diagnosis, const char *task)
{
    return (Diagnosis){.found = message_new("%s", diagnosis->found),
                       .cause = message_new("%s is wrong, too, and has a part in this", task),
                       .mistake = diagnosis->cause == NULL ? diagnosis->mistake : MISTAKE_NONE,
                       .evidence = diagnosis->evidence};
}

// What a check found comes of another task's answer, too. Where it fails alone as well, only the
// cause that it names is in doubt; where nobody could try that, it waits.
static void pass_blame(CheckResult *check, const char *task)
{
    check_tell(check, check->is_own
                          ? with_culprit(&check->diagnosis, task)
                          : diagnosis_new("waits for %s, which it needs and which is wrong: "
                                          "without its marker lines it cannot be tried alone",
                                          task));
    check->is_explained = 0;
    check->status = check->is_own ? CHECK_FAILED : CHECK_NOT_RUN;
}

void blame_others(const Check *checks, Result *result)
{
    const char *culprits[RESULT_MAX_CHECKS];
    for (int i = 0; i < result->n_checks; i++) {
        const int has_failed =
            result->checks[i].status == CHECK_FAILED && !result->checks[i].is_unanswered;
        culprits[i] = has_failed ? culprit_of(checks, result, i) : NULL;
    }
    for (int i = 0; i < result->n_checks; i++) {
        if (culprits[i] != NULL) {
            pass_blame(&result->checks[i], culprits[i]);
        }
    }
}
