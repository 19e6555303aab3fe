// Known answers: right ones and wrong ones, each a file with a header that says what must become of
// it (tests/mutants/README.md, tests/right/README.md).
//
// Used by mutants.c. Read next: groups.h.
#ifndef MUTATION_KNOWN_ANSWER_H
#define MUTATION_KNOWN_ANSWER_H

#include "session.h"

#define WRONG_FOLDER "tests/mutants"
#define RIGHT_FOLDER "tests/right"

enum { ANSWER_LINE_BYTES = 256 };

typedef struct KnownAnswer {
    const char *path;
    char *text;                     // the whole file; its header stays as comments
    const Task *task;               // whose hole it fills
    int is_right;                   // then the two below are not used
    char check[ANSWER_LINE_BYTES];  // by which it shall be caught
    char says[ANSWER_LINE_BYTES];   // regular expression for that check's message
    char never[ANSWER_LINE_BYTES];  // the same for what no check of its task may say; "" for none
    unsigned mistakes;              // of diagnosis.h, a bit for each; 0 when it is of none
    Mistake first_mistake;          // the one that must be named
    int is_tried_alone;             // besides (alone.h)
    // What became of it.
    char *why;       // it was not judged as it should be; NULL: it was. Owned
    unsigned named;  // the kinds of mistakes that were named, a bit for each
} KnownAnswer;

// Read an answer; its path and the manifest must stay. Returns 0, or -1 after one message;
// answer_free() it in either case.
int answer_read(KnownAnswer *answer, const Manifest *manifest, const char *path);
void answer_free(KnownAnswer *answer);

// The number of the check that the answer shall be caught by, or -1.
int answer_check(const Session *session, const KnownAnswer *answer);

// Choose which of n answers are tried alone, of those whose header does not say that the check
// passes there: each; or one of the wrong ones that a check is meant for and one of the right ones
// to a task, and the seed says which.
void answers_choose_alone(const Session *session, KnownAnswer *const answers[], int n, int is_each);

// Was the mistake named that must be?
int answer_is_named(const KnownAnswer *answer);

// The kinds of mistakes that were named and are not its own, a bit for each.
unsigned answer_misnamed(const KnownAnswer *answer);

#endif
