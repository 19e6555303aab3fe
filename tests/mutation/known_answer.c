// Reading known answers (see known_answer.h).
#include "known_answer.h"

#include "blame.h"
#include "complain.h"
#include "text_file.h"

#include <stdlib.h>
#include <string.h>

// The rest of the header line "// key: value". Returns 0, or -1 after one message.
static int read_header(const KnownAnswer *answer, const char *key, char value[ANSWER_LINE_BYTES])
{
    char prefix[ANSWER_LINE_BYTES];
    snprintf(prefix, sizeof prefix, "// %s: ", key);
    const char *line = strstr(answer->text, prefix);
    if (line == NULL) {
        complain("%s: no line \"%s...\"", answer->path, prefix);
        return -1;
    }
    line += strlen(prefix);
    snprintf(value, ANSWER_LINE_BYTES, "%.*s", (int)strcspn(line, "\n"), line);
    return 0;
}

// The kinds of mistake in the optional header line "// looks: kind kind". Returns 0, or -1 after
// one message.
static int read_mistakes(KnownAnswer *answer)
{
    char ids[ANSWER_LINE_BYTES];
    if (strstr(answer->text, "// looks: ") == NULL) {
        return 0;
    }
    if (read_header(answer, "looks", ids) != 0) {
        return -1;
    }
    char *rest = NULL;
    for (char *id = strtok_r(ids, " ", &rest); id != NULL; id = strtok_r(NULL, " ", &rest)) {
        const Mistake mistake = mistake_find(id);
        if (mistake == MISTAKE_NONE) {
            complain("%s: no kind of mistake is called \"%s\"", answer->path, id);
            return -1;
        }
        answer->first_mistake = answer->mistakes == 0 ? mistake : answer->first_mistake;
        answer->mistakes |= 1u << mistake;
    }
    return 0;
}

// The optional header line "// never says: ...". Returns 0, or -1 after one message.
static int read_never(KnownAnswer *answer)
{
    return strstr(answer->text, "// never says: ") == NULL
               ? 0
               : read_header(answer, "never says", answer->never);
}

int answer_check(const Session *session, const KnownAnswer *answer)
{
    for (int i = 0; i < session->judge.n_checks; i++) {
        if (strcmp(session->judge.checks[i].id, answer->check) == 0) {
            return i;
        }
    }
    return -1;
}

int answer_read(KnownAnswer *answer, const Manifest *manifest, const char *path)
{
    char task[ANSWER_LINE_BYTES], why_right[ANSWER_LINE_BYTES];
    *answer = (KnownAnswer){.path = path, .text = text_file_read(path)};
    answer->is_right = strncmp(path, RIGHT_FOLDER, strlen(RIGHT_FOLDER)) == 0;
    if (answer->text == NULL || read_header(answer, "task", task) != 0 ||
        (answer->is_right ? read_header(answer, "right", why_right)
                          : read_header(answer, "caught by", answer->check) |
                                read_header(answer, "says", answer->says)) != 0 ||
        read_never(answer) != 0 || read_mistakes(answer) != 0) {
        return -1;
    }
    answer->task = manifest_task(manifest, task);
    if (answer->task == NULL) {
        complain("%s: no task called %s", path, task);
        return -1;
    }
    return 0;
}

void answer_free(KnownAnswer *answer)
{
    free(answer->text);
    free(answer->why);
    *answer = (KnownAnswer){0};
}

int answer_is_named(const KnownAnswer *answer)
{
    return answer->mistakes != 0 && (answer->named >> answer->first_mistake & 1);
}

unsigned answer_misnamed(const KnownAnswer *answer)
{
    return answer->named & ~answer->mistakes;
}

// ---- Which are tried alone ----------------------------------------------------------------------

// How many answers are meant for a check, or are right ones to a task, and how many of them have
// had their turn.
typedef struct Turn {
    int n_meant;
    int n_past;
} Turn;

typedef struct Turns {
    Turn checks[RESULT_MAX_CHECKS];
    Turn tasks[MANIFEST_MAX_TASKS];
} Turns;

// Is it known that the check passes alone? The optional line "// alone: passes, ..." says why. That
// is not tried: who changes a stand-in looks at these lines.
static int passes_alone(const KnownAnswer *answer)
{
    return strstr(answer->text, "\n// alone: passes, ") != NULL;
}

// Whose turn it is when this answer comes: the check's it is meant for, or the task's of a right
// one. NULL where there is no such check, or where nothing is to be tried alone.
static Turn *turn_of(const Session *session, const KnownAnswer *answer, Turns *turns)
{
    const int check = answer->is_right ? -1 : answer_check(session, answer);
    if (passes_alone(answer)) {
        return NULL;
    }
    if (answer->is_right) {
        return &turns->tasks[answer->task - session->manifest.tasks];
    }
    return check >= 0 ? &turns->checks[check] : NULL;
}

void answers_choose_alone(const Session *session, KnownAnswer *const answers[], int n, int is_each)
{
    Turns turns = {0};
    for (int i = 0; i < n; i++) {
        Turn *turn = turn_of(session, answers[i], &turns);
        if (turn != NULL) {
            turn->n_meant++;
        }
    }
    for (int i = 0; i < n; i++) {
        const KnownAnswer *answer = answers[i];
        Turn *turn = turn_of(session, answer, &turns);
        const int is_its_turn = turn != NULL && turn->n_past++ == (int)(session->settings->seed %
                                                                        (uint64_t)turn->n_meant);
        // A check that needs no other task's answer is judged alone by the same inputs in the same
        // way, so nothing would be learnt.
        answers[i]->is_tried_alone =
            turn != NULL && (is_its_turn || is_each) &&
            (answer->is_right ||
             check_needs_others(&session->judge.checks[answer_check(session, answer)]));
    }
}
