// Finding whose fault it is that a check failed (see blame.h).
//
// Called by grading_judge.c. Read next: hints.c.
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
           (found->is_own || check_is_unanswered(found) || !check_needs_others(check));
}

// The tasks that a check needs and whose answers are wrong for certain.
typedef struct Culprits {
    const char *first;  // NULL where there is none
    int are_more;
    int is_own;  // the check's own task is one, too
} Culprits;

// Those of check number i. A check that could not be tried alone is its own task's fault where
// another check of it is.
static Culprits culprits_of(const Check *checks, const Result *result, int i)
{
    Culprits culprits = {.is_own = result->checks[i].is_own};
    for (int j = 0; j < result->n_checks; j++) {
        const int is_own_task = strcmp(checks[j].task, checks[i].task) == 0;
        const CheckResult *found = &result->checks[j];
        culprits.is_own |= is_own_task && is_fault(&checks[j], found);
        // What passes alone is right: what stands beside the answers is wrong then.
        if (!is_own_task && check_needs(&checks[i], checks[j].task) &&
            is_fault(&checks[j], found) && !found->passes_alone) {
            culprits.are_more |=
                culprits.first != NULL && strcmp(culprits.first, checks[j].task) != 0;
            culprits.first = culprits.first != NULL ? culprits.first : checks[j].task;
        }
    }
    return culprits;
}

// The same facts without their cause, which another task may have a part in; what the cause named
// goes with it. Where it passes alone and one other answer is wrong, that one has its part.
static Diagnosis without_cause(const CheckResult *check, Culprits culprits)
{
    const Diagnosis *diagnosis = &check->diagnosis;
    const int is_known = check->passes_alone && !culprits.are_more;
    char *cause = NULL;
    if (check->alone != NULL) {
        cause = message_new("%s; %s is wrong, too, and may have a part in what was found",
                            check->alone, culprits.first);
    } else if (is_known) {
        cause = message_new("alone it passes: %s is wrong, and has a part in this", culprits.first);
    }
    return (Diagnosis){.found = message_new("%s", diagnosis->found),
                       .cause = cause,
                       .mistake = diagnosis->cause == NULL ? diagnosis->mistake : MISTAKE_NONE,
                       .evidence = diagnosis->evidence,
                       .silence = diagnosis->silence};
}

// What a check found comes of another task's answer, too. Where its own is wrong as well, only the
// cause that it names is in doubt; where nobody could try that, it waits.
static void pass_blame(CheckResult *check, Culprits culprits)
{
    check_tell(check, culprits.is_own
                          ? without_cause(check, culprits)
                          : diagnosis_silent(SILENCE_UNTRIED,
                                             "waits for %s, which it needs and which is wrong: "
                                             "without its marker lines it cannot be tried alone",
                                             culprits.first));
    check->is_explained = 0;
    check->status = culprits.is_own ? CHECK_FAILED : CHECK_NOT_RUN;
}

void blame_others(const Check *checks, Result *result)
{
    Culprits culprits[RESULT_MAX_CHECKS];
    for (int i = 0; i < result->n_checks; i++) {
        const CheckResult *check = &result->checks[i];
        const int has_failed =
            check->status == CHECK_FAILED && !check_is_unanswered(check) && !check->is_told_alone;
        culprits[i] = has_failed ? culprits_of(checks, result, i) : (Culprits){0};
    }
    for (int i = 0; i < result->n_checks; i++) {
        if (culprits[i].first != NULL) {
            pass_blame(&result->checks[i], culprits[i]);
        }
    }
}
