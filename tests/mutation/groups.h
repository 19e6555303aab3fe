// Groups of known answers: what stands in the solution together is compiled and run once.
//
// In one variant each answer fills the hole of another task. Right answers must pass every check
// together as they must one by one. Wrong ones stand together where no check of a task needs a
// neighbour's answer: then neighbours have no part in what is said of any.
//
// Used by mutants.c. Read next: groups_try.c.
#ifndef MUTATION_GROUPS_H
#define MUTATION_GROUPS_H

#include "known_answer.h"
#include "session.h"

// How many groups run side by side.
enum { PAIR = 2 };

typedef struct Group {
    KnownAnswer *answers[MANIFEST_MAX_TASKS];  // each to another task, all right or all wrong
    int n;
    Variant variant;
} Group;

// The number of the check that the answer shall be caught by, or -1: it is right.
int answer_check(const Session *session, const KnownAnswer *answer);

// Choose which of n answers are tried alone, of those that do not say that the check passes there:
// each; or one of the wrong ones that a check is meant for and one of the right ones to a task, and
// the seed says which.
void answers_choose_alone(const Session *session, KnownAnswer *const answers[], int n, int is_each);

// Put n answers into groups, in their order: each by itself, or as many together as may be.
//   groups[n]   out: n of them are enough
// Returns how many groups there are.
int groups_form(const Session *session, KnownAnswer *const answers[], int n, int is_each_by_itself,
                Group groups[]);

// Run up to PAIR groups in the solution, and those of their answers alone that shall be, and note
// in each answer what became of it. Where one of a group is not judged as it should be, its answers
// are tried one by one, and only that counts. Returns 0, or -1 after one message when the machinery
// failed.
int groups_try(Session *session, Group groups[], int n);

#endif
