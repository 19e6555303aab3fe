// mutants: try known answers in the solution and alone (alone.h): wrong ones, each of which the
// check meant for it must catch in both, with the right message, and right ones written another
// way, which must pass every check.
//
//     mutants [--together] [--seeds N] [--only WORD] [--every N] --lab 01 [--seed N]
//
// --seeds says for how many seeds, from --seed on, each must be so; one is the default. Jobs of
// further seeds are run beside the first, by programs that are compiled once. --only tries those
// whose name holds the word, --every of the wrong ones each N-th in their order, and as many others
// as it takes that each check and each kind of mistake has one.
//
// Each answer stands by itself in the solution. With --together answers to different tasks stand
// there together where that says as much of each (groups.h); and where one of them is not judged as
// it should be, each is tried by itself after all, and only that counts.
//
// To be tried alone is to be compiled and run once more. Each answer is; with --together one of the
// wrong ones that a check is meant for, and one right one of each task, and the seed says which.
//
// Prints TAP, a line for each answer of tests/known/NN-name/ (tests/known/README.md). Exit status:
// 0 all judged as they should be, 1 some not, 2 the machinery failed, or an answer cannot be read.
#include "complain.h"
#include "groups.h"
#include "number.h"
#include "session.h"
#include "settings.h"

#include <stdlib.h>
#include <string.h>

// For more than one; for one goes the grader's own limit (allowance.h).
enum { SECONDS_A_SEED = 10 };

// The largest N of --every.
enum { MOST_LEFT_OUT = 100 };

// What this program's own options say.
typedef struct Trial {
    int n_further;     // seeds besides the first
    const char *only;  // "" for all
    uint64_t every;    // 1 tries all wrong answers, 2 every second, ...
    int is_together;
} Trial;

// How well the reports name kinds of mistakes (diagnosis.h).
typedef struct Naming {
    int n_of_a_kind;  // mutants whose header says which
    int n_named;      // of those, by a failed check of the task
    int n_misnamed;   // of all mutants, those named as what they are not
} Naming;

// The share of the mutants of a known kind that must be named.
#define NAMED_SHARE 0.9

// Print how an answer's mistake was named where it was not as it should be, and count it.
static void report_kind(const KnownAnswer *answer, Naming *naming)
{
    const unsigned strange = answer_misnamed(answer);
    naming->n_of_a_kind += answer->mistakes != 0;
    naming->n_named += answer_is_named(answer);
    naming->n_misnamed += strange != 0;
    if (answer->mistakes != 0 && !answer_is_named(answer)) {
        printf("  # %s: not named as %s\n", answer->name, mistake_name(answer->first_mistake));
    }
    for (Mistake mistake = 0; mistake < N_MISTAKES; mistake++) {
        if (strange >> mistake & 1) {
            printf("  # %s: named as %s\n", answer->name, mistake_name(mistake));
        }
    }
}

// Print a TAP line for an answer, test number `number`. Returns whether it failed.
static int report_answer(const KnownAnswer *answer, int number, Naming *naming)
{
    const int length = (int)(strrchr(answer->path, '/') - answer->path);
    printf("%sok %d - %.*s/%s\n", answer->why ? "not " : "", number, length, answer->path,
           answer->name);
    if (answer->why != NULL) {
        printf("  # %s:%d: %s\n", answer->path, answer->line, answer->why);
    }
    report_kind(answer, naming);
    return answer->why != NULL;
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

// Note what a wrong answer is meant for. Is it the first one there?
static int note_kind(Covered *covered, const Session *session, const KnownAnswer *answer)
{
    const int check = answer_check(session, answer);
    int is_first = check >= 0 && covered->checks[check]++ == 0;
    is_first |= answer->mistakes != 0 && covered->mistakes[answer->first_mistake]++ == 0;
    return is_first;
}

// Of n answers choose those that are to be tried, in their order.
//   chosen[n]   out
// Returns how many.
static int choose(const Session *session, const Trial *trial, KnownAnswer answers[], int n,
                  KnownAnswer *chosen[])
{
    const int every = (int)trial->every;
    Covered covered = {0};
    int n_chosen = 0;
    for (int i = 0; i < n; i += every) {
        note_kind(&covered, session, &answers[i]);
    }
    for (int i = 0; i < n; i++) {
        if (answers[i].is_right || i % every == 0 || note_kind(&covered, session, &answers[i])) {
            chosen[n_chosen++] = &answers[i];
        }
    }
    return n_chosen;
}

// Try n answers and print what became of each, and of all. Returns an exit status.
//   groups[n]   room for them
static int try_chosen(Session *session, KnownAnswer *const chosen[], int n, int is_each_by_itself,
                      Group groups[])
{
    Naming naming = {0};
    int n_reported = 0, n_missed = 0;
    answers_choose_alone(session, chosen, n, is_each_by_itself);
    const int n_groups = groups_form(session, chosen, n, is_each_by_itself, groups);
    for (int g = 0; g < n_groups; g++) {
        if (g % PAIR == 0 &&
            groups_try(session, groups + g, n_groups - g < PAIR ? n_groups - g : PAIR) != 0) {
            return 2;
        }
        for (int i = 0; i < groups[g].n; i++) {
            n_missed += report_answer(groups[g].answers[i], ++n_reported, &naming);
        }
    }
    n_missed += report_naming(&naming, session->manifest.lab, n);
    printf("1..%d\n", n + 2);
    return n_missed > 0;
}

// Memory for n things, or NULL after one message.
static void *allocate(size_t n, size_t n_bytes)
{
    void *memory = calloc(n + 1, n_bytes);
    if (memory == NULL) {
        complain("mutants: out of memory");
    }
    return memory;
}

// Try those of the answers that shall be. Returns an exit status.
static int try_answers(Session *session, const Trial *trial, KnownAnswers *answers)
{
    int n = answers->n, status = 2;
    KnownAnswer **chosen = allocate((size_t)n, sizeof *chosen);
    Group *groups = chosen != NULL ? allocate((size_t)n, sizeof *groups) : NULL;
    if (groups != NULL) {
        n = choose(session, trial, answers->all, n, chosen);
        status = try_chosen(session, chosen, n, !trial->is_together, groups);
    }
    free(groups);
    free(chosen);
    return status;
}

// The solution first, then every known answer of the lab. Returns an exit status.
static int try_all(Session *session, const Trial *trial)
{
    static KnownAnswers answers;
    Variant *solution[] = {&session->solution};
    int status = 2;
    int is_read = known_answers_read(&answers, &session->manifest) == 0;
    if (is_read && answers.n == 0) {
        complain("mutants: " KNOWN_FOLDER "/%s: found no answers", session->manifest.lab);
        is_read = 0;
    }
    if (is_read && session_add_seeds(session, trial->n_further) == 0 &&
        session_run(session, solution, 1) == 0 && session_trust_solution(session) == 0) {
        known_answers_keep(&answers, trial->only);
        // "/" is in no name: then only the solution is run.
        if (answers.n == 0 && strcmp(trial->only, "/") != 0) {
            complain("mutants: --only: no answer of %s has \"%s\" in its name",
                     session->manifest.lab, trial->only);
        } else {
            status = try_answers(session, trial, &answers);
        }
    }
    known_answers_free(&answers);
    return status;
}

// Take this program's own options, which come first, from the words. Returns 0, or -1 after one
// message.
static int read_trial(int *argc, char ***argv, Trial *trial)
{
    uint64_t n_seeds = 1;
    *trial = (Trial){.only = "", .every = 1};
    while (*argc > 2) {
        int n_taken = 2;
        if (strcmp((*argv)[1], "--together") == 0) {
            trial->is_together = 1;
            n_taken = 1;
        } else if (strcmp((*argv)[1], "--only") == 0) {
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
        (*argv)[n_taken] = (*argv)[0];  // its name, in messages
        *argc -= n_taken;
        *argv += n_taken;
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
