// mutate: put mechanical mistakes into the solution of a lab, one at a time, and count how many the
// judge notices.
//
//     mutate [--list] [--stride N] [--offset K] --lab 03 [--seed N] [--time-limit S]
//
// Tries the mutations number K, K + N, K + 2 N, ... (all, unless told otherwise), names those that
// pass every check, and ends with one line of figures. Those that change nothing that counts stand
// with the reason in tests/mutation/equivalent.txt. Exit status: 0 at least 95 in 100 of the others
// are noticed, 1 fewer or the list is wrong, 2 the machinery failed. Read next: mutations.h.
#include "complain.h"
#include "holes.h"
#include "message.h"
#include "mutations.h"
#include "number.h"
#include "path.h"
#include "session.h"
#include "settings.h"
#include "text_file.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Two run side by side, as mutants do. KILLED_PERCENT is what the course promises.
enum { PAIR = 2, ID_BYTES = 512, KILLED_PERCENT = 95 };

static const char EQUIVALENT_PATH[] = "tests/mutation/equivalent.txt";

typedef struct Options {
    int list;  // only print what there is
    int stride, offset;
} Options;

typedef enum Fate { NOT_TRIED, NOT_COMPILING, KILLED, SURVIVED } Fate;

// A mutation of one task's hole.
typedef struct Mutant {
    char *id;  // "leaf_loop:17:compare:<:<="
    const Task *task;
    const char *hole;  // the solution's text, the task's
    const Mutation *mutation;
    int is_listed;  // as equivalent
    Fate fate;
} Mutant;

// All mutants of a lab.
typedef struct Population {
    char *holes[MANIFEST_MAX_TASKS];
    Mutations mutations[MANIFEST_MAX_TASKS];
    Mutant *mutants;  // [n]
    int n;
} Population;

// ---- Which there are ----------------------------------------------------------------------------

static int add_task(Population *population, Session *session, int task_number)
{
    const Task *task = &session->manifest.tasks[task_number];
    char path[PATH_MAX];
    path_make(path, "solutions/%s/%s", session->manifest.lab, task->file);
    char *hole = hole_load(path, task->id);
    population->holes[task_number] = hole;
    Mutations *mutations = &population->mutations[task_number];
    if (hole == NULL || mutations_find(hole, mutations) != 0) {
        complain("mutate: %s: task %s cannot be read", path, task->id);
        return -1;
    }
    const size_t n = (size_t)(population->n + mutations->n);
    Mutant *mutants = realloc(population->mutants, (n + 1) * sizeof *mutants);
    if (mutants == NULL) {
        fprintf(stderr, "mutate: no memory\n");
        return -1;
    }
    population->mutants = mutants;
    for (int i = 0; i < mutations->n; i++) {
        const Mutation *mutation = &mutations->all[i];
        mutants[population->n++] = (Mutant){
            .id = message_new("%s:%s", task->id, mutation->id),
            .task = task,
            .hole = hole,
            .mutation = mutation,
        };
    }
    return 0;
}

static void population_free(Population *population)
{
    for (int i = 0; i < population->n; i++) {
        free(population->mutants[i].id);
    }
    for (int i = 0; i < MANIFEST_MAX_TASKS; i++) {
        mutations_free(&population->mutations[i]);
        free(population->holes[i]);
    }
    free(population->mutants);
}

// Note which mutants the file of equivalents names: lines "03 id reason". Returns how many of the
// lab's lines name none, each with a message, or -1 after one.
static int mark_equivalents(Population *population, const char *lab)
{
    int n_unknown = 0;
    char *text = text_file_read(EQUIVALENT_PATH);
    char *rest = text, *line;
    while (rest != NULL && (line = strsep(&rest, "\n")) != NULL) {
        char number[8], id[ID_BYTES];
        if (line[0] == '#' || sscanf(line, "%7s %511s", number, id) != 2 ||
            strncmp(number, lab, 2) != 0) {
            continue;
        }
        int is_known = 0;
        for (int i = 0; i < population->n; i++) {
            const int is_this = strcmp(population->mutants[i].id, id) == 0;
            population->mutants[i].is_listed |= is_this;
            is_known |= is_this;
        }
        if (!is_known) {
            printf("%s: %s %s: there is no such mutant any more\n", EQUIVALENT_PATH, number, id);
            n_unknown++;
        }
    }
    free(text);
    return text != NULL ? n_unknown : -1;
}

// Print the mutant's id and the line it changes, after the change.
static void print_mutant(const char *what, const Mutant *mutant)
{
    const Mutation *mutation = mutant->mutation;
    const char *place = mutant->hole + mutation->start;
    const char *line = place;
    while (line > mutant->hole && line[-1] != '\n') {
        line--;
    }
    line += strspn(line, " ");
    const char *behind = place + mutation->length;
    printf("%s%s  %.*s%s%.*s\n", what, mutant->id, (int)(place - line), line, mutation->replacement,
           (int)strcspn(behind, "\n"), behind);
}

// ---- Trying -------------------------------------------------------------------------------------

// What became of a mutant that has run: every check of the lab counts.
static Fate judge_fate(Session *session, const Variant *variant)
{
    if (variant->build_log != NULL) {
        return NOT_COMPILING;
    }
    for (int i = 0; i < session->judge.n_checks; i++) {
        CheckResult result = {0};
        session_judge(session, 0, i, variant, &result);
        check_free(&result);
        if (result.status != CHECK_PASSED) {
            return KILLED;
        }
    }
    return SURVIVED;
}

// Run up to PAIR mutants side by side. Returns 0, or -1 after one message.
static int try_mutants(Session *session, Mutant *const mutants[], int n)
{
    Variant opened[PAIR] = {{.run = NULL}};
    Variant *variants[PAIR];
    int result = 0;
    for (int i = 0; i < n; i++) {
        char name[24];
        snprintf(name, sizeof name, "mutant-%d", i);
        char *answer = mutation_apply(mutants[i]->hole, mutants[i]->mutation);
        variants[i] = &opened[i];
        result |=
            session_fill(session, name, &(HoleAnswer){mutants[i]->task, answer}, 1, variants[i]);
        free(answer);
    }
    result = result != 0 ? result : session_run(session, variants, n);
    for (int i = 0; i < n; i++) {
        mutants[i]->fate = result == 0 ? judge_fate(session, variants[i]) : NOT_TRIED;
        variant_free(variants[i]);
    }
    return result;
}

static int try_all(Session *session, Population *population, Options options)
{
    Mutant *pair[PAIR];
    int n = 0, result = 0;
    for (int i = options.offset; result == 0 && i < population->n; i += options.stride) {
        pair[n++] = &population->mutants[i];
        if (n == PAIR || i + options.stride >= population->n) {
            result = try_mutants(session, pair, n);
            n = 0;
        }
    }
    return result;
}

// Name the survivors and what the list says wrongly; then the figures. Returns an exit status.
static int report(const Population *population, const char *lab, int n_unknown)
{
    int n_tried = 0, n_not_compiling = 0, n_killed = 0, n_equivalent = 0, n_survived = 0;
    int n_wrong = n_unknown;
    for (int i = 0; i < population->n; i++) {
        const Mutant *mutant = &population->mutants[i];
        const Fate fate = mutant->fate;
        n_tried += fate != NOT_TRIED;
        n_not_compiling += fate == NOT_COMPILING;
        n_killed += fate == KILLED;
        n_equivalent += fate == SURVIVED && mutant->is_listed;
        n_survived += fate == SURVIVED && !mutant->is_listed;
        if (fate == SURVIVED && !mutant->is_listed) {
            print_mutant("survived: ", mutant);
        }
        if (mutant->is_listed && (fate == KILLED || fate == NOT_COMPILING)) {
            printf("%s: %.2s %s: it %s\n", EQUIVALENT_PATH, lab, mutant->id,
                   fate == KILLED ? "loses points" : "does not compile");
            n_wrong++;
        }
    }
    const int n_counted = n_killed + n_survived;
    printf("%s: %d of %d tried, %d not compiling, %d killed, %d equivalent, %d survived: %.1f %%\n",
           lab, n_tried, population->n, n_not_compiling, n_killed, n_equivalent, n_survived,
           n_counted > 0 ? 100.0 * n_killed / n_counted : 100.0);
    return 100 * n_killed < KILLED_PERCENT * n_counted || n_wrong > 0;
}

static int mutate(Session *session, Options options)
{
    Population population = {0};
    Variant *solution[] = {&session->solution};
    int failed = 0, n_unknown = 0, status = 2;
    for (int i = 0; !failed && i < session->manifest.n_tasks; i++) {
        failed = add_task(&population, session, i) != 0;
    }
    if (!failed && options.list) {
        for (int i = 0; i < population.n; i++) {
            print_mutant("", &population.mutants[i]);
        }
        status = 0;
    } else if (!failed && session_run(session, solution, 1) == 0 &&
               session_trust_solution(session) == 0 &&
               (n_unknown = mark_equivalents(&population, session->manifest.lab)) >= 0 &&
               try_all(session, &population, options) == 0) {
        status = report(&population, session->manifest.lab, n_unknown);
    }
    population_free(&population);
    return status;
}

// ---- The command line ---------------------------------------------------------------------------

// Take this program's own options off the front; the others are the grader's. Returns how many
// words were taken, or -1 after one message.
static int read_options(int argc, char **argv, Options *options)
{
    int n = 1;
    *options = (Options){.stride = 1};
    for (; n < argc; n++) {
        const int is_stride = strcmp(argv[n], "--stride") == 0;
        if (strcmp(argv[n], "--list") == 0) {
            options->list = 1;
            continue;
        }
        if (!is_stride && strcmp(argv[n], "--offset") != 0) {
            break;
        }
        const int lowest = is_stride ? 1 : 0;
        const char *text = n + 1 < argc ? argv[n + 1] : "";
        int64_t number;
        if (number_read_integer(text, lowest, INT_MAX, &number) != 0) {
            complain("mutate: %s: found \"%s\", expected a whole number from %d on", argv[n], text,
                     lowest);
            return -1;
        }
        *(is_stride ? &options->stride : &options->offset) = (int)number;
        n++;
    }
    return n - 1;
}

int main(int argc, char **argv)
{
    Options options;
    Settings settings;
    const int n_taken = read_options(argc, argv, &options);
    if (n_taken < 0) {
        return 2;
    }
    const int parsed = settings_parse(argc - n_taken, argv + n_taken, &settings);
    if (parsed != 0) {
        return parsed > 0 ? 0 : 2;
    }
    Session session;
    int status = 2;
    if (session_open(&session, &settings) == 0) {
        status = mutate(&session, options);
    }
    session_close(&session);
    return status;
}
