// pairs: put two known-wrong answers to different tasks into the solution, judge that as a
// submission, and compare what is named of the first one with what is named of it by itself.
//
//     pairs [--pairs N] --lab 03 [--seed N]
//
// Draws N pairs by the seed, 60 unless told otherwise. Prints a line for each whose first answer is
// named otherwise, with what was said, and then of how many the first is named as by itself, of how
// many it is not named, and of how many otherwise. Exit status: 0 named as by itself or not at all
// in at least 95 of 100, 1 in fewer, 2 the machinery failed. Read next: known_answer.h.
#include "complain.h"
#include "grading.h"
#include "known_answer.h"
#include "number.h"
#include "random.h"

#include <stdlib.h>
#include <string.h>

enum { USUAL_PAIRS = 60, MOST_PAIRS = 1000, LEAST_PERCENT = 95 };

// How the first answer of a pair is named.
typedef enum Naming {
    NAMED_ALIKE,  // or neither here nor by itself
    UNNAMED,
    NAMED_OTHERWISE,
    N_NAMINGS
} Naming;

// What checks of one task name, each text owned; NULL for those that name nothing.
typedef struct Causes {
    char *of[RESULT_MAX_CHECKS];
} Causes;

static void causes_free(Causes *causes)
{
    for (int i = 0; i < RESULT_MAX_CHECKS; i++) {
        free(causes->of[i]);
    }
    *causes = (Causes){0};
}

static void forget(Grading *grading)
{
    const Session session = grading->session;
    for (int t = 0; t < MANIFEST_MAX_TASKS; t++) {
        variant_free(&grading->alone[t]);
    }
    variant_free(&grading->whole);
    result_free(&grading->result);
    *grading = (Grading){.session = session};
}

// Judge n answers in the solution as a submission is judged, and take what the checks of the first
// one's task name. Returns 0, or -1 after one message.
static int find_causes(Grading *grading, KnownAnswer *const answers[], int n, Causes *causes)
{
    Session *session = &grading->session;
    Variant *whole[] = {&grading->whole};
    HoleAnswer holes[2];
    for (int i = 0; i < n; i++) {
        holes[i] = (HoleAnswer){answers[i]->task, answers[i]->text};
    }
    grading_list_checks(grading);
    int result = session_fill(session, "whole", holes, n, &grading->whole);
    grading->whole.task = NULL;  // a submission, of which nothing is known
    result = result == 0 ? session_run(session, whole, 1) : result;
    result = result == 0 ? grading_judge(grading) : result;
    for (int i = 0; result == 0 && i < grading->result.n_checks; i++) {
        CheckResult *check = &grading->result.checks[i];
        if (strcmp(check->task, answers[0]->task->id) == 0 && check->is_explained) {
            causes->of[i] = check->diagnosis.cause;
            check->diagnosis.cause = NULL;
        }
    }
    forget(grading);
    return result;
}

// Does a check of the answer by itself say this, maybe with other words around it?
static int is_said(const Causes *single, const char *cause)
{
    int is_found = 0;
    for (int i = 0; i < RESULT_MAX_CHECKS; i++) {
        is_found |= single->of[i] != NULL && strstr(cause, single->of[i]) != NULL;
    }
    return is_found;
}

static Naming compare(const Causes *single, const Causes *paired)
{
    int n_single = 0, n_paired = 0, n_alike = 0;
    for (int i = 0; i < RESULT_MAX_CHECKS; i++) {
        n_single += single->of[i] != NULL;
        n_paired += paired->of[i] != NULL;
        n_alike += paired->of[i] != NULL && is_said(single, paired->of[i]);
    }
    return n_alike < n_paired ? NAMED_OTHERWISE : n_paired < (n_single > 0) ? UNNAMED : NAMED_ALIKE;
}

// Try one pair. Returns how the first is named, or -1 after one message.
static int try_pair(Grading *grading, KnownAnswer *const pair[2])
{
    Causes single = {0}, paired = {0};
    int naming = -1;
    if (find_causes(grading, pair, 1, &single) == 0 &&
        find_causes(grading, pair, 2, &paired) == 0) {
        naming = compare(&single, &paired);
    }
    if (naming > NAMED_ALIKE) {
        printf("%s beside %s: %s\n", pair[0]->name, pair[1]->name,
               naming == UNNAMED ? "unnamed" : "named otherwise");
    }
    for (int i = 0; naming > NAMED_ALIKE && i < grading->session.judge.n_checks; i++) {
        const char *id = grading->session.judge.checks[i].id;
        if (single.of[i] != NULL || paired.of[i] != NULL) {
            printf("  %s by itself: %s\n", id, single.of[i] ? single.of[i] : "-");
            printf("  %s beside it: %s\n", id, paired.of[i] ? paired.of[i] : "-");
        }
    }
    causes_free(&single);
    causes_free(&paired);
    return naming;
}

// Draw and try pairs, and print the figures. Returns an exit status.
static int try_pairs(Grading *grading, KnownAnswer answers[], int n, int n_pairs)
{
    Random random = {grading->session.settings->seed};
    int n_named[N_NAMINGS] = {0};
    for (int i = 0; i < n_pairs; i++) {
        KnownAnswer *pair[2];
        do {
            pair[0] = &answers[random_integer(&random, 0, n - 1)];
            pair[1] = &answers[random_integer(&random, 0, n - 1)];
        } while (pair[0]->task == pair[1]->task);
        const int naming = try_pair(grading, pair);
        if (naming < 0) {
            return 2;
        }
        n_named[naming]++;
    }
    printf("%s: of %d pairs the first answer is named as by itself in %d, not named in %d, "
           "otherwise in %d\n",
           grading->session.manifest.lab, n_pairs, n_named[NAMED_ALIKE], n_named[UNNAMED],
           n_named[NAMED_OTHERWISE]);
    return 100 * n_named[NAMED_OTHERWISE] > (100 - LEAST_PERCENT) * n_pairs;
}

// How many wrong answers there are, which come first; they must be of two tasks. -1 after one
// message.
static int count_wrong(const KnownAnswers *answers, const char *lab)
{
    int n = 0, n_others = 0;
    for (; n < answers->n && !answers->all[n].is_right; n++) {
        n_others += answers->all[n].task != answers->all[0].task;
    }
    if (n_others == 0) {
        complain("pairs: " KNOWN_FOLDER "/%s: found no wrong answers to two tasks", lab);
        return -1;
    }
    return n;
}

// The solution first, then the pairs. Returns an exit status.
static int try_all(Grading *grading, int n_pairs)
{
    static KnownAnswers answers;
    Session *session = &grading->session;
    Variant *solution[] = {&session->solution};
    int status = 2;
    if (known_answers_read(&answers, &session->manifest) == 0 &&
        session_run(session, solution, 1) == 0 && session_trust_solution(session) == 0) {
        const int n = count_wrong(&answers, session->manifest.lab);
        status = n > 0 ? try_pairs(grading, answers.all, n, n_pairs) : 2;
    }
    known_answers_free(&answers);
    return status;
}

int main(int argc, char **argv)
{
    static Grading grading;
    Settings settings;
    uint64_t n_pairs = USUAL_PAIRS;
    if (argc > 2 && strcmp(argv[1], "--pairs") == 0) {
        if (number_read_unsigned(argv[2], 1, MOST_PAIRS, &n_pairs) != 0) {
            complain("pairs: --pairs: found \"%s\", expected a whole number from 1 to %d", argv[2],
                     MOST_PAIRS);
            return 2;
        }
        argv[2] = argv[0];  // its name, in messages
        argc -= 2;
        argv += 2;
    }
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? 0 : 2;
    }
    const int status =
        session_open(&grading.session, &settings) == 0 ? try_all(&grading, (int)n_pairs) : 2;
    session_close(&grading.session);
    return status;
}
