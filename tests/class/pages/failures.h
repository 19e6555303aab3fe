// What went wrong in a class, over all faults of all who count: the same check, and the same cause
// or sentence about it.
//
// Two students with the same mistake meet different hidden scenes: what differs in their sentences
// is numbers, and those are left out of the comparison. Read next: failures.c.
#ifndef CLASS_FAILURES_H
#define CLASS_FAILURES_H

#include "gradebook.h"

typedef struct Failure {
    int check;             // of the gradebook; -1: of a stage, such as the compiler
    const char *title;     // of the check or stage
    const char *id;        // of the check, else ""
    const char *cause;     // the known mistake, a fixed sentence, or NULL
    const char *sentence;  // else the first row's, which stands for all
    const Row **rows;      // [n_rows] in the gradebook's order
    int n_rows;
    const Row *shown;  // of those with a picture the one with the fewest other faults, or NULL
} Failure;

typedef struct Failures {
    Failure *failures;  // the largest group first
    int n_failures;
    const Row **rows;  // all groups' rows, one behind the other
} Failures;

// Group all faults of the rows that count: checks that failed, of tasks that were answered, and of
// a stage the first that failed. Returns 0, or -1 after one message on stderr. Release with
// failures_free().
int failures_find(const Gradebook *gradebook, Failures *failures);
void failures_free(Failures *failures);

#endif
