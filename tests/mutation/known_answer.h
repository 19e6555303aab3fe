// Known answers: right ones and wrong ones, in two files a lab, each as edits of the solution with
// what must become of it (tests/known/README.md).
//
// Used by mutants.c, known.c and copies/given.c. Read next: edits.h, groups.h.
#ifndef MUTATION_KNOWN_ANSWER_H
#define MUTATION_KNOWN_ANSWER_H

#include "diagnosis.h"
#include "manifest.h"

#include <limits.h>

#define KNOWN_FOLDER "tests/known"

enum { N_KNOWN_FILES = 2, KNOWN_MAX = 512 };

typedef struct KnownAnswer {
    const char *path;       // of its file
    int line;               // there, from 1
    const char *name;       // no other answer of the lab has it
    char *text;             // what fills the hole. Owned
    const Task *task;       // whose hole that is
    int is_right;           // then the four below are not used
    const char *check;      // by which it shall be caught
    const char *says;       // regular expression for that check's message
    const char *never;      // the same for what no check of its task may say; NULL for none
    int passes_alone;       // the check passes when it is tried alone, and that is known
    unsigned mistakes;      // of diagnosis.h, a bit for each; 0 when it is of none
    Mistake first_mistake;  // the one that must be named
    int is_tried_alone;     // besides (alone.h)
    // What became of it.
    char *why;       // it was not judged as it should be; NULL: it was. Owned
    unsigned named;  // the kinds of mistakes that were named, a bit for each
} KnownAnswer;

// The known answers of a lab, in the order of their files, the wrong ones first.
typedef struct KnownAnswers {
    KnownAnswer all[KNOWN_MAX];
    int n;
    // Of both files, to which the answers point: path, and text, owned.
    char paths[N_KNOWN_FILES][PATH_MAX];
    char *texts[N_KNOWN_FILES];
} KnownAnswers;

// Read all known answers of a lab; the manifest must stay. A file that is not there has none.
// Returns 0, or -1 after a message with file and line: for each answer with an edit that does not
// fit the solution, or one for a task or check that the lab does not have, a line that says nothing
// known.
// known_answers_free() them in either case.
int known_answers_read(KnownAnswers *answers, const Manifest *manifest);
void known_answers_free(KnownAnswers *answers);

// The answer of this name, or NULL.
KnownAnswer *known_answers_find(KnownAnswers *answers, const char *name);

// Keep those whose name has the word in it, in their order.
void known_answers_keep(KnownAnswers *answers, const char *word);

// Was the mistake named that must be?
int answer_is_named(const KnownAnswer *answer);

// The kinds of mistakes that were named and are not its own, a bit for each.
unsigned answer_misnamed(const KnownAnswer *answer);

#endif
