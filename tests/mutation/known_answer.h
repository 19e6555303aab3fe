// Known answers: right ones and wrong ones, each a file with a header that says what must become of
// it (tests/mutants/README.md, tests/right/README.md).
//
// Used by mutants.c.
#ifndef MUTATION_KNOWN_ANSWER_H
#define MUTATION_KNOWN_ANSWER_H

#include "session.h"

#define WRONG_FOLDER "tests/mutants"
#define RIGHT_FOLDER "tests/right"

enum { ANSWER_LINE_BYTES = 256 };

typedef struct KnownAnswer {
    const char *path;
    char *text;                     // the whole file; its header stays as comments
    char task[ANSWER_LINE_BYTES];   // whose hole it fills
    int is_right;                   // then the two below are not used
    char check[ANSWER_LINE_BYTES];  // by which it shall be caught
    char says[ANSWER_LINE_BYTES];   // regular expression for that check's message
    unsigned mistakes;              // of diagnosis.h, a bit for each; 0 when it is of none
    Mistake first_mistake;          // the one that must be named
    Variant variant;                // in the solution of the other tasks
    int is_tried_alone;
    Variant alone;
} KnownAnswer;

// How many answers are meant for a check, or are right ones to a task, and how many of them have
// had their turn.
typedef struct Turn {
    int n_meant;
    int n_past;
} Turn;

// Which answers are tried alone, of those whose header does not say that the check passes there:
// each; or one of the wrong ones that a check is meant for and one of the right ones to a task, and
// the seed says which.
typedef struct Turns {
    uint64_t seed;
    int is_each_alone;
    Turn checks[RESULT_MAX_CHECKS];
    Turn tasks[MANIFEST_MAX_TASKS];
} Turns;

// Is the file at this path a right answer?
int is_right_answer(const char *path);

// Read an answer: all but its variants. Returns 0, or -1 after one message; answer_free() it in
// either case.
int answer_read(KnownAnswer *answer, const char *path);

// Count the turns in these n files; nothing has been counted before.
void turns_count(Turns *turns, const Session *session, char *const *paths, int n);

// Read an answer and make its variants: in the solution of the other tasks, and alone where it is
// its turn.
//   slot   tells the folders of answers apart that run side by side
// Returns 0, or -1 after one message; answer_free() it in either case.
int answer_open(KnownAnswer *answer, Session *session, const char *path, int slot, Turns *turns);
void answer_free(KnownAnswer *answer);

// The number of the check that the answer shall be caught by, or -1.
int answer_check(const Session *session, const KnownAnswer *answer);

#endif
