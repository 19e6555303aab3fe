// Running groups of known answers and judging each (see groups.h).
#include "groups.h"

#include "alone.h"
#include "message.h"

#include <inttypes.h>
#include <regex.h>
#include <stdlib.h>
#include <string.h>

// ---- Judging ------------------------------------------------------------------------------------

// Does the message match the expression, in any case of letters?
static int matches(const char *message, const char *expression)
{
    regex_t compiled;
    if (regcomp(&compiled, expression, REG_EXTENDED | REG_ICASE | REG_NOSUB) != 0) {
        return 0;
    }
    const int found = regexec(&compiled, message, 0, NULL, 0) == 0;
    regfree(&compiled);
    return found;
}

// What check i says in the job of the k-th seed.
static CheckResult judge_in(Session *session, int k, int i, const Variant *variant)
{
    CheckResult result = {0};
    session_judge(session, k, i, variant, &result);
    return result;
}

static uint64_t seed_of(const Session *session, int k)
{
    return session->settings->seed + (uint64_t)k;
}

static int is_of_task(const Session *session, int i, const KnownAnswer *answer)
{
    return strcmp(session->judge.checks[i].task, answer->task->id) == 0;
}

// Why check i did not catch a wrong answer as it should in the job of the k-th seed, or NULL. Owned
// by the caller.
static char *judge_wrong_in(Session *session, int k, int i, const KnownAnswer *answer,
                            const Variant *variant)
{
    CheckResult result = judge_in(session, k, i, variant);
    char *why = NULL;
    if (result.status == CHECK_PASSED) {
        why = message_new("%s passed with seed %" PRIu64, answer->check, seed_of(session, k));
    } else if (!matches(result.message, answer->says)) {
        why = message_new("%s says with seed %" PRIu64 " \"%s\", expected /%s/", answer->check,
                          seed_of(session, k), result.message, answer->says);
    }
    check_free(&result);
    return why;
}

// Which check of the answer's task says in the job of the k-th seed what none may say, or NULL.
// Owned by the caller.
static char *judge_never_in(Session *session, int k, const KnownAnswer *answer,
                            const Variant *variant)
{
    char *why = NULL;
    for (int i = 0; why == NULL && answer->never != NULL && i < session->judge.n_checks; i++) {
        CheckResult result = {0};
        if (is_of_task(session, i, answer)) {
            result = judge_in(session, k, i, variant);
        }
        if (result.message != NULL && matches(result.message, answer->never)) {
            why = message_new("%s says with seed %" PRIu64 " \"%s\", and /%s/ is not true",
                              session->judge.checks[i].id, seed_of(session, k), result.message,
                              answer->never);
        }
        check_free(&result);
    }
    return why;
}

// Why a wrong answer was not caught as it should be, or NULL. Owned by the caller.
static char *judge_wrong(Session *session, const KnownAnswer *answer, const Variant *variant)
{
    const int i = answer_check(session, answer);
    char *why = NULL;
    for (int k = 0; why == NULL && k <= session->workdir.n_further_jobs; k++) {
        why = judge_wrong_in(session, k, i, answer, variant);
        why = why == NULL ? judge_never_in(session, k, answer, variant) : why;
    }
    return why;
}

// The first check that right answers lost, or NULL. Owned by the caller.
static char *judge_right(Session *session, const Variant *variant)
{
    char *why = NULL;
    for (int i = 0; why == NULL && i < session->judge.n_checks; i++) {
        for (int k = 0; why == NULL && k <= session->workdir.n_further_jobs; k++) {
            CheckResult result = judge_in(session, k, i, variant);
            if (result.status != CHECK_PASSED) {
                why = message_new("%s, seed %" PRIu64 ": %s", session->judge.checks[i].id,
                                  seed_of(session, k), result.message);
            }
            check_free(&result);
        }
    }
    return why;
}

// Which kinds of mistakes do the failed checks of the answer's task name in the k-th job?
static unsigned mistakes_named_in(Session *session, int k, const KnownAnswer *answer,
                                  const Variant *variant)
{
    unsigned named = 0;
    for (int i = 0; i < session->judge.n_checks; i++) {
        if (is_of_task(session, i, answer)) {
            CheckResult result = judge_in(session, k, i, variant);
            named |= 1u << result.diagnosis.mistake;
            check_free(&result);
        }
    }
    return named & ~(1u << MISTAKE_NONE);
}

// A mistake must be named in the first job, and in none as what it is not.
static unsigned mistakes_named(Session *session, const KnownAnswer *answer, const Variant *variant)
{
    unsigned named = mistakes_named_in(session, 0, answer, variant);
    for (int k = 1; k <= session->workdir.n_further_jobs; k++) {
        named |= mistakes_named_in(session, k, answer, variant) & ~answer->mistakes;
    }
    return named;
}

// Note what became of an answer that has run in the solution. Returns whether it was judged as it
// should be, and its kind named.
static int judge_answer(Session *session, KnownAnswer *answer, const Variant *variant)
{
    free(answer->why);
    answer->why = variant->build_log != NULL
                      ? message_new("it does not compile: %s", variant->build_log)
                  : answer->is_right ? judge_right(session, variant)
                                     : judge_wrong(session, answer, variant);
    answer->named = mistakes_named(session, answer, variant);
    return answer->why == NULL && answer_misnamed(answer) == 0 &&
           (answer->mistakes == 0 || answer_is_named(answer));
}

// Judge the answers of a group that has run. Returns whether what was noted of each counts: it is
// by itself, or all have come to their end and are judged as they should be.
static int judge_group(Session *session, const Group *group)
{
    const Variant *variant = &group->variant;
    int counts = group->n == 1 || (variant->build_log == NULL && variant->trouble == NULL);
    for (int i = 0; counts && i < group->n; i++) {
        // Where one right answer has passed every check, so have those beside it.
        if (i == 0 || !group->answers[i]->is_right) {
            counts = judge_answer(session, group->answers[i], variant) || group->n == 1;
        }
    }
    return counts;
}

static int alone_passes(Session *session, int i, const Variant *alone)
{
    return judge_passes_alone(&session->judge, variant_answers(alone), i);
}

// Note where an answer that was judged as it should be in the solution was not so alone.
static void judge_alone(Session *session, KnownAnswer *answer, const Variant *alone)
{
    const int caught_by = answer_check(session, answer);
    for (int i = 0; answer->why == NULL && i < session->judge.n_checks; i++) {
        if (answer->is_right && is_of_task(session, i, answer) &&
            !alone_passes(session, i, alone)) {
            answer->why =
                message_new("%s: it fails alone%s%s", session->judge.checks[i].id,
                            alone->build_log ? ": " : "", alone->build_log ? alone->build_log : "");
        } else if (!answer->is_right && i == caught_by && alone_passes(session, i, alone)) {
            answer->why = message_new("%s passes alone", answer->check);
        }
    }
}

// ---- Running ------------------------------------------------------------------------------------

static int group_fill(Session *session, Group *group, int slot)
{
    char name[24];
    HoleAnswer answers[MANIFEST_MAX_TASKS];
    for (int i = 0; i < group->n; i++) {
        answers[i] = (HoleAnswer){group->answers[i]->task, group->answers[i]->text};
    }
    snprintf(name, sizeof name, "answer-%d", slot);
    return session_fill(session, name, answers, group->n, &group->variant);
}

// Run up to PAIR groups side by side in the solution and judge their answers.
//   counts[n]   out: does what was noted of the group's answers count?
// Returns 0, or -1 after one message, as all below.
static int run_groups(Session *session, Group groups[], int n, int counts[])
{
    Variant *variants[PAIR] = {NULL};
    int result = 0;
    for (int i = 0; i < n; i++) {
        variants[i] = &groups[i].variant;
        result |= group_fill(session, &groups[i], i);
    }
    result = result != 0 ? result : session_run(session, variants, n);
    for (int i = 0; i < n; i++) {
        counts[i] = result == 0 && judge_group(session, &groups[i]);
        variant_free(variants[i]);
    }
    return result;
}

static int try_one_by_one(Session *session, const Group *group)
{
    int counts[PAIR], result = 0;
    for (int i = 0; result == 0 && i < group->n; i += PAIR) {
        Group ones[PAIR] = {{.n = 0}};
        int n = 0;
        for (; n < PAIR && i + n < group->n; n++) {
            ones[n] = (Group){.answers = {group->answers[i + n]}, .n = 1};
        }
        result = run_groups(session, ones, n, counts);
    }
    return result;
}

// Run up to PAIR answers side by side, each alone.
static int run_alone(Session *session, KnownAnswer *const answers[], int n)
{
    Variant alone[PAIR] = {{.run = NULL}};
    Variant *variants[PAIR] = {NULL};
    int result = 0;
    for (int i = 0; i < n; i++) {
        char name[24];
        snprintf(name, sizeof name, "alone-%d", i);
        variants[i] = &alone[i];
        result |= alone_fill(session, name, answers[i]->task, answers[i]->text, NULL, variants[i]);
    }
    result = result != 0 ? result : session_run(session, variants, n);
    for (int i = 0; i < n; i++) {
        if (result == 0) {
            judge_alone(session, answers[i], variants[i]);
        }
        variant_free(variants[i]);
    }
    return result;
}

static int try_alone(Session *session, const Group groups[], int n)
{
    KnownAnswer *alone[PAIR * MANIFEST_MAX_TASKS];
    int n_alone = 0, result = 0;
    for (int g = 0; g < n; g++) {
        for (int i = 0; i < groups[g].n; i++) {
            KnownAnswer *answer = groups[g].answers[i];
            if (answer->is_tried_alone && answer->why == NULL) {
                alone[n_alone++] = answer;
            }
        }
    }
    for (int i = 0; result == 0 && i < n_alone; i += PAIR) {
        result = run_alone(session, alone + i, n_alone - i < PAIR ? n_alone - i : PAIR);
    }
    return result;
}

int groups_try(Session *session, Group groups[], int n)
{
    int counts[PAIR];
    int result = run_groups(session, groups, n, counts);
    for (int i = 0; result == 0 && i < n; i++) {
        result = counts[i] ? 0 : try_one_by_one(session, &groups[i]);
    }
    return result == 0 ? try_alone(session, groups, n) : -1;
}
