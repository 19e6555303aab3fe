// Rows that failed alike: the same check first, and the same sentence about it.
//
// Two students with the same mistake meet different hidden scenes: what differs in their sentences
// is numbers, and those are left out of the comparison. Read next: failures.c.
#ifndef CLASS_FAILURES_H
#define CLASS_FAILURES_H

#include "gradebook.h"

typedef struct Failure {
    const Row *first;  // the first row of the group, whose sentence stands for all
    int n_rows;
    const Row **rows;  // [n_rows] in the gradebook's order
} Failure;

typedef struct Failures {
    Failure *failures;  // the largest group first
    int n_failures;
    const Row **rows;  // all groups' rows, one behind the other
} Failures;

// Group the rows that have a fault. Returns 0, or -1 after one message on stderr. Release with
// failures_free().
int failures_find(const Gradebook *gradebook, Failures *failures);
void failures_free(Failures *failures);

#endif
