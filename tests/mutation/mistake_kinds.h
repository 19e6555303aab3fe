// The kinds of mistakes that a report must be able to name, each with what its sentence says.
//
// Used by mutants.c, which measures how often the right kind is named: the table, in words, is in
// tests/mutants/README.md. The sentences themselves are written where the mistake is recognised:
// picture_looks.c and the judges.
#ifndef GRADER_MISTAKE_KINDS_H
#define GRADER_MISTAKE_KINDS_H

typedef struct MistakeKind {
    const char *id;    // "flipped-y", as in a mutant's header "// looks: flipped-y"
    const char *says;  // extended regular expression, in any case, for the sentence that names it
} MistakeKind;

enum { N_MISTAKE_KINDS = 12 };
extern const MistakeKind mistake_kinds[N_MISTAKE_KINDS];

// Is there a kind of this name? Returns its number, or -1.
int mistake_kind_find(const char *id);

// Which kinds does a message name? A bit for each: 1 << number.
unsigned mistake_kinds_named(const char *message);

#endif
