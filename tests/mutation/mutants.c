// mutants: try known answers, one at a time, in the solution and alone (alone.h): wrong ones,
// each of which the check meant for it must catch in both, with the right message, and right ones
// written another way, which must pass every check.
//
//     mutants [--seeds N] [--only WORD] [--every N] --lab 01 [--seed N]
//
// --seeds says for how many seeds, from --seed on, each must be so; one is the default. Jobs of
// further seeds are run beside the first, by programs that are compiled once. --only tries those
// whose path holds the word, --every of the wrong ones each N-th in the order of their names, and
// as many others as it takes that each check and each kind of mistake has one.
//
// To be tried alone is to be compiled and run once more. Each answer is; with --every one of the
// wrong ones that a check is meant for, and one right one of each task, and the seed says which.
//
// Prints TAP, a line for each file in tests/mutants/NN-name/ and tests/right/NN-name/. Their format
// stands in tests/mutants/README.md and tests/right/README.md. Exit status: 0 all judged as they
// should be, 1 some not, 2 the machinery failed.
#include "alone.h"
#include "complain.h"
#include "known_answer.h"
#include "message.h"
#include "number.h"
#include "session.h"
#include "settings.h"

#include <glob.h>
#include <inttypes.h>
#include <regex.h>
#include <stdlib.h>
#include <string.h>

enum { PAIR = 2 };

// For more than one; for one goes the grader's own limit (allowance.h).
enum { SECONDS_A_SEED = 10 };

// The largest N of --every.
enum { MOST_LEFT_OUT = 100 };

// What this program's own options say.
typedef struct Trial {
    int n_further;     // seeds besides the first
    const char *only;  // "" for all
    uint64_t every;    // 1 tries all wrong answers, 2 every second, ...
} Trial;

// How well the reports name kinds of mistakes (diagnosis.h).
typedef struct Naming {
    int n_of_a_kind;  // mutants whose header says which
    int n_named;      // of those, by a failed check of the task
    int n_misnamed;   // of all mutants, those named as what they are not
} Naming;

// The share of the mutants of a known kind that must be named.
#define NAMED_SHARE 0.9

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

// Why check i did not catch a wrong answer as it should in the job of the k-th seed, or NULL. Owned
// by the caller.
static char *judge_wrong_in(Session *session, int k, int i, const KnownAnswer *answer)
{
    CheckResult result = judge_in(session, k, i, &answer->variant);
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

// Why a wrong answer was not caught as it should be, or NULL. Owned by the caller.
static char *judge_wrong(Session *session, const KnownAnswer *answer)
{
    const int i = answer_check(session, answer);
    if (i < 0) {
        return message_new("no check called %s", answer->check);
    }
    if (strcmp(session->judge.checks[i].task, answer->task) != 0) {
        return message_new("%s belongs to another task", answer->check);
    }
    char *why = NULL;
    for (int k = 0; why == NULL && k <= session->workshop.n_further_jobs; k++) {
        why = judge_wrong_in(session, k, i, answer);
    }
    if (why == NULL && answer->is_tried_alone && alone_passes(session, i, &answer->alone)) {
        why = message_new("%s passes alone", answer->check);
    }
    return why;
}

// Which kinds of mistakes do the failed checks of the answer's task name in the k-th job?
static unsigned mistakes_named(Session *session, int k, const KnownAnswer *answer)
{
    unsigned named = 0;
    for (int i = 0; i < session->judge.n_checks; i++) {
        if (strcmp(session->judge.checks[i].task, answer->task) == 0) {
            CheckResult result = judge_in(session, k, i, &answer->variant);
            named |= 1u << result.diagnosis.mistake;
            check_free(&result);
        }
    }
    return named & ~(1u << MISTAKE_NONE);
}

// A mistake must be named in the first job, and in none as what it is not.
static void judge_naming(Session *session, const KnownAnswer *answer, Naming *naming)
{
    unsigned named = mistakes_named(session, 0, answer);
    for (int k = 1; k <= session->workshop.n_further_jobs; k++) {
        named |= mistakes_named(session, k, answer) & ~answer->mistakes;
    }
    const unsigned strange = named & ~answer->mistakes;
    const int is_named = answer->mistakes != 0 && (named >> answer->first_mistake & 1);
    naming->n_of_a_kind += answer->mistakes != 0;
    naming->n_named += is_named;
    naming->n_misnamed += strange != 0;
    if (answer->mistakes != 0 && !is_named) {
        printf("  # %s: not named as %s\n", answer->path, mistake_name(answer->first_mistake));
    }
    for (Mistake mistake = 0; mistake < N_MISTAKES; mistake++) {
        if (strange >> mistake & 1) {
            printf("  # %s: named as %s\n", answer->path, mistake_name(mistake));
        }
    }
}

// The first check that a right answer lost, or NULL. Owned by the caller.
static char *judge_right(Session *session, const KnownAnswer *answer)
{
    char *why = NULL;
    for (int i = 0; why == NULL && i < session->judge.n_checks; i++) {
        for (int k = 0; why == NULL && k <= session->workshop.n_further_jobs; k++) {
            CheckResult result = judge_in(session, k, i, &answer->variant);
            if (result.status != CHECK_PASSED) {
                why = message_new("%s, seed %" PRIu64 ": %s", session->judge.checks[i].id,
                                  seed_of(session, k), result.message);
            }
            check_free(&result);
        }
        if (why == NULL && strcmp(session->judge.checks[i].task, answer->task) == 0 &&
            answer->is_tried_alone && !alone_passes(session, i, &answer->alone)) {
            why = message_new("%s: it fails alone%s%s", session->judge.checks[i].id,
                              answer->alone.build_log ? ": " : "",
                              answer->alone.build_log ? answer->alone.build_log : "");
        }
    }
    return why;
}

// Why an answer was not judged as it should be, or NULL. Owned by the caller.
static char *judge_answer(Session *session, const KnownAnswer *answer)
{
    if (answer->variant.build_log != NULL) {
        return message_new("it does not compile: %s", answer->variant.build_log);
    }
    return answer->is_right ? judge_right(session, answer) : judge_wrong(session, answer);
}

// Run up to PAIR answers side by side and print a TAP line for each. Returns how many were not
// judged as they should be, or -1 after one message.
static int try_answers(Session *session, char *const paths[], int n, int first_number, Turns *turns,
                       Naming *naming)
{
    KnownAnswer answers[PAIR] = {{0}};
    Variant *variants[2 * PAIR];
    int n_variants = 0, n_missed = 0;
    for (int i = 0; i < n; i++) {
        n_missed |= answer_open(&answers[i], session, paths[i], i, turns);
        variants[n_variants++] = &answers[i].variant;
        if (answers[i].is_tried_alone) {
            variants[n_variants++] = &answers[i].alone;
        }
    }
    if (n_missed == 0 && session_run(session, variants, n_variants) != 0) {
        n_missed = -1;
    }
    for (int i = 0; n_missed >= 0 && i < n; i++) {
        char *why = judge_answer(session, &answers[i]);
        printf("%sok %d - %s\n", why ? "not " : "", first_number + i, paths[i] + strlen("tests/"));
        if (why != NULL) {
            printf("  # %s\n", why);
            n_missed++;
        }
        free(why);
        judge_naming(session, &answers[i], naming);
    }
    for (int i = 0; i < n; i++) {
        answer_free(&answers[i]);
    }
    return n_missed;
}

// Print how well a lab's mistakes were named, as tests after n mutants. Returns how many failed.
static int report_naming(const Naming *naming, const char *lab, int n)
{
    const int is_named = naming->n_named >= NAMED_SHARE * naming->n_of_a_kind;
    const int is_never_wrong = naming->n_misnamed == 0;
    printf("%sok %d - %s: of %d mutants of a known kind %d are named as what they are\n",
           is_named ? "" : "not ", n + 1, lab, naming->n_of_a_kind, naming->n_named);
    printf("%sok %d - %s: of %d answers %d are named as what they are not\n",
           is_never_wrong ? "" : "not ", n + 2, lab, n, naming->n_misnamed);
    return !is_named + !is_never_wrong;
}

// What the wrong answers that are to be tried are meant for.
typedef struct Covered {
    int checks[RESULT_MAX_CHECKS];
    int mistakes[N_MISTAKES];
} Covered;

// Note what an answer is meant for. Is it the first one there, or can nothing be told of it, so
// that trying it will say what is wrong?
static int is_first_of_its_kind(Covered *covered, const Session *session, const char *path)
{
    KnownAnswer answer;
    const int is_read = answer_read(&answer, path) == 0;
    const int check = answer_check(session, &answer);
    int is_first = !is_read || (!answer.is_right && check < 0);
    if (!is_first && !answer.is_right) {
        is_first |= covered->checks[check]++ == 0;
        is_first |= answer.mistakes != 0 && covered->mistakes[answer.first_mistake]++ == 0;
    }
    answer_free(&answer);
    return is_first;
}

// Of n paths leave those that are to be tried, in their order. Returns how many, or -1 when memory
// runs out.
static int choose(const Session *session, const Trial *trial, char *paths[], int n)
{
    enum { LEFT_OUT, CHOSEN };
    char *marks = calloc((size_t)n + 1, 1);
    Covered covered = {0};
    int n_chosen = 0;
    if (marks == NULL) {
        return -1;
    }
    for (int i = 0; i < n; i++) {
        if (is_right_answer(paths[i]) || i % (int)trial->every == 0) {
            marks[i] = CHOSEN;
            is_first_of_its_kind(&covered, session, paths[i]);
        }
    }
    for (int i = 0; i < n; i++) {
        if (marks[i] == CHOSEN || is_first_of_its_kind(&covered, session, paths[i])) {
            paths[n_chosen++] = paths[i];
        }
    }
    free(marks);
    return n_chosen;
}

// The paths in which the word stands. What glob() found must be freed in whole, so the list is
// another one: of n paths, owned by the caller. NULL when memory runs out.
static char **find_word(const glob_t *found, const char *word, int *n)
{
    char **paths = calloc(found->gl_pathc + 1, sizeof *paths);
    *n = 0;
    for (size_t i = 0; paths != NULL && i < found->gl_pathc; i++) {
        if (strstr(found->gl_pathv[i], word) != NULL) {
            paths[(*n)++] = found->gl_pathv[i];
        }
    }
    return paths;
}

// The solution first, then every known answer of the lab. Returns an exit status.
static int try_all(Session *session, const Trial *trial)
{
    char pattern[ANSWER_LINE_BYTES];
    Variant *solution[] = {&session->solution};
    glob_t found;
    if (session_add_seeds(session, trial->n_further) != 0 ||
        session_run(session, solution, 1) != 0 || session_trust_solution(session) != 0) {
        return 2;
    }
    snprintf(pattern, sizeof pattern, "{" WRONG_FOLDER "," RIGHT_FOLDER "}/%s/*.c*",
             session->manifest.lab);
    if (glob(pattern, GLOB_BRACE, NULL, &found) != 0) {
        complain("mutants: %s: none found", pattern);
        return 2;
    }
    int n, n_missed = 0;
    Naming naming = {0};
    char **paths = find_word(&found, trial->only, &n);
    n = paths != NULL ? choose(session, trial, paths, n) : -1;
    if (n < 0) {
        complain("mutants: out of memory");
        return 2;
    }
    Turns turns = {.is_each_alone = trial->every == 1};
    turns_count(&turns, session, paths, n);
    for (int i = 0; n_missed >= 0 && i < n; i += PAIR) {
        const int missed =
            try_answers(session, paths + i, n - i < PAIR ? n - i : PAIR, i + 1, &turns, &naming);
        n_missed = missed < 0 ? -1 : n_missed + missed;
    }
    free(paths);
    globfree(&found);
    n_missed = n_missed < 0 ? -1 : n_missed + report_naming(&naming, session->manifest.lab, n);
    printf("1..%d\n", n + 2);
    return n_missed < 0 ? 2 : n_missed > 0;
}

// Take this program's own options, which come first, from the words. Returns 0, or -1 after one
// message.
static int read_trial(int *argc, char ***argv, Trial *trial)
{
    uint64_t n_seeds = 1;
    *trial = (Trial){.only = "", .every = 1};
    while (*argc > 2) {
        if (strcmp((*argv)[1], "--only") == 0) {
            trial->only = (*argv)[2];
        } else if (strcmp((*argv)[1], "--every") == 0) {
            if (number_read_unsigned((*argv)[2], 1, MOST_LEFT_OUT, &trial->every) != 0) {
                complain("mutants: --every: found \"%s\", expected a whole number from 1 to %d",
                         (*argv)[2], MOST_LEFT_OUT);
                return -1;
            }
        } else if (strcmp((*argv)[1], "--seeds") != 0) {
            break;
        } else if (number_read_unsigned((*argv)[2], 1, 1 + MAX_FURTHER_JOBS, &n_seeds) != 0) {
            complain("mutants: --seeds: found \"%s\", expected a whole number from 1 to %d",
                     (*argv)[2], 1 + MAX_FURTHER_JOBS);
            return -1;
        }
        (*argv)[2] = (*argv)[0];  // its name, in messages
        *argc -= 2;
        *argv += 2;
    }
    trial->n_further = (int)n_seeds - 1;
    return 0;
}

int main(int argc, char **argv)
{
    Settings settings;
    Trial trial;
    if (read_trial(&argc, &argv, &trial) != 0) {
        return 2;
    }
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? 0 : 2;
    }
    if (settings.time_limit == 0 && trial.n_further > 0) {
        settings.time_limit = SECONDS_A_SEED * (1 + trial.n_further);
    }
    Session session;
    int status = 2;
    if (session_open(&session, &settings) == 0) {
        status = try_all(&session, &trial);
    }
    session_close(&session);
    return status;
}
