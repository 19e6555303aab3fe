// Which known answers are tried alone (see groups.h).
#include "groups.h"

#include "blame.h"

#include <string.h>

int answer_check(const Session *session, const KnownAnswer *answer)
{
    for (int i = 0; !answer->is_right && i < session->judge.n_checks; i++) {
        if (strcmp(session->judge.checks[i].id, answer->check) == 0) {
            return i;
        }
    }
    return -1;
}

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

// Whose turn it is when this answer comes: the check's it is meant for, or the task's of a right
// one. NULL where there is no such check, or where nothing is to be tried alone.
static Turn *turn_of(const Session *session, const KnownAnswer *answer, Turns *turns)
{
    const int check = answer_check(session, answer);
    if (answer->passes_alone) {
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
