// Reading known answers (see known_answer.h).
#include "known_answer.h"

#include "alone.h"
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

int answer_check(const Session *session, const KnownAnswer *answer)
{
    for (int i = 0; i < session->judge.n_checks; i++) {
        if (strcmp(session->judge.checks[i].id, answer->check) == 0) {
            return i;
        }
    }
    return -1;
}

// Is it known that the check passes alone? The optional line "// alone: passes, ..." says why. That
// is not tried: who changes a stand-in looks at these lines.
static int passes_alone(const KnownAnswer *answer)
{
    return strstr(answer->text, "\n// alone: passes, ") != NULL;
}

// Whose turn it is when this answer comes: the check's it is meant for, or the task's of a right
// one. NULL where there is no such check or task, or where nothing is to be tried alone.
static Turn *turn_of(const Session *session, const KnownAnswer *answer, Turns *turns)
{
    const Task *task = manifest_task(&session->manifest, answer->task);
    const int check = answer->is_right ? -1 : answer_check(session, answer);
    if (passes_alone(answer)) {
        return NULL;
    }
    if (answer->is_right) {
        return task != NULL ? &turns->tasks[task - session->manifest.tasks] : NULL;
    }
    return check >= 0 ? &turns->checks[check] : NULL;
}

// Shall it be tried alone? A check that needs no other task's answer is judged there by the same
// inputs in the same way, so nothing would be learnt.
static int is_to_be_alone(const Session *session, const KnownAnswer *answer, Turns *turns)
{
    Turn *turn = turn_of(session, answer, turns);
    if (turn == NULL) {
        return 0;
    }
    const int is_its_turn = turn->n_past++ == (int)(turns->seed % (uint64_t)turn->n_meant);
    return (is_its_turn || turns->is_each_alone) &&
           (answer->is_right ||
            check_needs_others(&session->judge.checks[answer_check(session, answer)]));
}

int is_right_answer(const char *path)
{
    return strncmp(path, RIGHT_FOLDER, strlen(RIGHT_FOLDER)) == 0;
}

int answer_read(KnownAnswer *answer, const char *path)
{
    char why_right[ANSWER_LINE_BYTES];
    *answer = (KnownAnswer){.path = path, .text = text_file_read(path)};
    answer->is_right = is_right_answer(path);
    return answer->text == NULL || read_header(answer, "task", answer->task) != 0 ||
                   (answer->is_right ? read_header(answer, "right", why_right)
                                     : read_header(answer, "caught by", answer->check) |
                                           read_header(answer, "says", answer->says)) != 0 ||
                   read_mistakes(answer) != 0
               ? -1
               : 0;
}

void turns_count(Turns *turns, const Session *session, char *const *paths, int n)
{
    turns->seed = session->settings->seed;
    for (int i = 0; i < n; i++) {
        KnownAnswer answer;
        Turn *turn = answer_read(&answer, paths[i]) == 0 ? turn_of(session, &answer, turns) : NULL;
        if (turn != NULL) {
            turn->n_meant++;
        }
        answer_free(&answer);
    }
}

int answer_open(KnownAnswer *answer, Session *session, const char *path, int slot, Turns *turns)
{
    char whole[24], alone[24];
    if (answer_read(answer, path) != 0) {
        return -1;
    }
    if (manifest_task(&session->manifest, answer->task) == NULL) {
        complain("%s: no task called %s", path, answer->task);
        return -1;
    }
    const Task *task = manifest_task(&session->manifest, answer->task);
    snprintf(whole, sizeof whole, "answer-%d", slot);
    snprintf(alone, sizeof alone, "alone-%d", slot);
    const int filled = session_fill(session, whole, answer->task, answer->text, &answer->variant);
    answer->is_tried_alone = is_to_be_alone(session, answer, turns);
    return !answer->is_tried_alone
               ? filled
               : filled | alone_fill(session, alone, task, answer->text, NULL, &answer->alone);
}

void answer_free(KnownAnswer *answer)
{
    variant_free(&answer->variant);
    variant_free(&answer->alone);
    free(answer->text);
    *answer = (KnownAnswer){0};
}
