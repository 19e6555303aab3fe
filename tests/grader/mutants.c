// mutants: put known-wrong answers into the solution, one at a time, and see that each is caught by
// the check meant for it, with the right message.
//
//     mutants --lab 01 [--seed N]
//
// Prints TAP, a line for each file in tests/mutants/NN-name/. The format of a mutant stands in
// tests/mutants/README.md. Exit status: 0 all caught, 1 some not, 2 the machinery failed.
#include "holes.h"
#include "message.h"
#include "session.h"
#include "settings.h"
#include "text_file.h"

#include <glob.h>
#include <regex.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_BYTES = 256, PAIR = 2 };

typedef struct Mutant {
    const char *path;
    char *answer;            // the whole file; its header stays as comments
    char task[LINE_BYTES];   // whose hole it fills
    char check[LINE_BYTES];  // by which it shall be caught
    char says[LINE_BYTES];   // regular expression for that check's message
    Variant variant;
} Mutant;

// The rest of the header line "// key: value". Returns 0, or -1 after one message.
static int read_header(const Mutant *mutant, const char *key, char value[LINE_BYTES])
{
    char prefix[LINE_BYTES];
    snprintf(prefix, sizeof prefix, "// %s: ", key);
    const char *line = strstr(mutant->answer, prefix);
    if (line == NULL) {
        fprintf(stderr, "%s: no line \"%s...\"\n", mutant->path, prefix);
        return -1;
    }
    line += strlen(prefix);
    snprintf(value, LINE_BYTES, "%.*s", (int)strcspn(line, "\n"), line);
    return 0;
}

static int mutant_open(Mutant *mutant, const Session *session, const char *path, int slot)
{
    char name[16];
    *mutant = (Mutant){.path = path, .answer = text_file_read(path)};
    if (mutant->answer == NULL || read_header(mutant, "task", mutant->task) != 0 ||
        read_header(mutant, "caught by", mutant->check) != 0 ||
        read_header(mutant, "says", mutant->says) != 0) {
        return -1;
    }
    if (manifest_task(&session->manifest, mutant->task) == NULL) {
        fprintf(stderr, "%s: no task called %s\n", path, mutant->task);
        return -1;
    }
    snprintf(name, sizeof name, "mutant-%d", slot);
    return session_fill(session, name, mutant->task, mutant->answer, &mutant->variant);
}

static void mutant_free(Mutant *mutant)
{
    variant_free(&mutant->variant);
    free(mutant->answer);
    *mutant = (Mutant){0};
}

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

// Why the mutant was not caught as it should be, or NULL. Owned by the caller.
static char *judge_mutant(const Session *session, const Mutant *mutant)
{
    char *why = message_new("no check called %s", mutant->check);
    for (int i = 0; i < session->judge->n_checks; i++) {
        if (strcmp(session->judge->checks[i].id, mutant->check) != 0) {
            continue;
        }
        CheckResult result = {.message = NULL};
        session_judge(session, i, &mutant->variant, &result);
        free(why);
        why = NULL;
        if (mutant->variant.build_log != NULL) {
            why = message_new("it does not compile: %s", mutant->variant.build_log);
        } else if (strcmp(session->judge->checks[i].task, mutant->task) != 0) {
            why = message_new("%s belongs to another task", mutant->check);
        } else if (result.status == CHECK_PASSED) {
            why = message_new("%s passed", mutant->check);
        } else if (!matches(result.message, mutant->says)) {
            why = message_new("%s says \"%s\", expected /%s/", mutant->check, result.message,
                              mutant->says);
        }
        free(result.message);
        break;
    }
    return why;
}

// Run up to PAIR mutants side by side and print a TAP line for each. Returns how many were not
// caught, or -1 after one message.
static int try_mutants(const Session *session, char *const paths[], int n, int first_number)
{
    Mutant mutants[PAIR] = {{0}};
    Variant *variants[PAIR];
    int n_missed = 0;
    for (int i = 0; i < n; i++) {
        variants[i] = &mutants[i].variant;
        if (mutant_open(&mutants[i], session, paths[i], i) != 0) {
            n_missed = -1;
        }
    }
    if (n_missed == 0 && session_run(session, variants, n) != 0) {
        n_missed = -1;
    }
    for (int i = 0; n_missed >= 0 && i < n; i++) {
        char *why = judge_mutant(session, &mutants[i]);
        printf("%sok %d - %s\n", why ? "not " : "", first_number + i,
               paths[i] + strlen("tests/mutants/"));
        if (why != NULL) {
            printf("  # %s\n", why);
            n_missed++;
        }
        free(why);
    }
    for (int i = 0; i < n; i++) {
        mutant_free(&mutants[i]);
    }
    return n_missed;
}

// The solution first, then every mutant of the lab. Returns an exit status.
static int try_all(Session *session)
{
    char pattern[LINE_BYTES];
    Variant *solution[] = {&session->solution};
    glob_t found;
    if (session_run(session, solution, 1) != 0 || session_trust_solution(session) != 0) {
        return 2;
    }
    snprintf(pattern, sizeof pattern, "tests/mutants/%s/*.c*", session->manifest.lab);
    if (glob(pattern, 0, NULL, &found) != 0) {
        fprintf(stderr, "mutants: %s: none found\n", pattern);
        return 2;
    }
    int n_missed = 0;
    const int n = (int)found.gl_pathc;
    for (int i = 0; n_missed >= 0 && i < n; i += PAIR) {
        const int missed =
            try_mutants(session, found.gl_pathv + i, n - i < PAIR ? n - i : PAIR, i + 1);
        n_missed = missed < 0 ? -1 : n_missed + missed;
    }
    globfree(&found);
    printf("1..%d\n", n);
    return n_missed < 0 ? 2 : n_missed > 0;
}

int main(int argc, char **argv)
{
    Settings settings;
    const int parsed = settings_parse(argc, argv, &settings);
    if (parsed != 0) {
        return parsed > 0 ? 0 : 2;
    }
    Session session;
    int status = 2;
    const SessionSettings session_settings = {settings.lab,  settings.build,      settings.device,
                                              settings.seed, settings.time_limit, settings.sandbox};
    if (session_open(&session, session_settings) == 0) {
        status = try_all(&session);
    }
    session_close(&session);
    return status;
}
