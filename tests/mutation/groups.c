// Which known answers stand in the solution together (see groups.h).
#include "groups.h"

#include "blame.h"

#include <string.h>

// Has a neighbour's answer a part in what is said of this one? All that comes of its task's checks:
// the one that shall catch it is one of them, and each that fails may name the kind of mistake.
static int has_part(const Session *session, const KnownAnswer *neighbour, const KnownAnswer *answer)
{
    for (int i = 0; i < session->judge.n_checks; i++) {
        const Check *check = &session->judge.checks[i];
        if (strcmp(check->task, answer->task->id) == 0 && check_needs(check, neighbour->task->id)) {
            return 1;
        }
    }
    return 0;
}

// May two answers stand in the solution together? What a right one must pass, one beside it must
// pass, too; so it does not matter who has a part in it.
static int are_compatible(const Session *session, const KnownAnswer *a, const KnownAnswer *b)
{
    return a->task != b->task && a->is_right == b->is_right &&
           (a->is_right || (!has_part(session, a, b) && !has_part(session, b, a)));
}

static int fits(const Session *session, const Group *group, const KnownAnswer *answer)
{
    for (int i = 0; i < group->n; i++) {
        if (!are_compatible(session, group->answers[i], answer)) {
            return 0;
        }
    }
    return 1;
}

int groups_form(const Session *session, KnownAnswer *const answers[], int n, int is_each_by_itself,
                Group groups[])
{
    int n_groups = 0;
    for (int i = 0; i < n; i++) {
        int g = is_each_by_itself ? n_groups : 0;
        while (g < n_groups && !fits(session, &groups[g], answers[i])) {
            g++;
        }
        if (g == n_groups) {
            groups[n_groups++] = (Group){.n = 0};
        }
        groups[g].answers[groups[g].n++] = answers[i];
    }
    return n_groups;
}
