// Pairs over several labs: who is alike in one lab after the other.
//
// Who is who across labs is what the table of a term says (../class/term/term.h).
#ifndef COPIES_TERM_H
#define COPIES_TERM_H

#include "alike.h"
#include "term.h"

// Two persons in one lab.
typedef struct LabPair {
    int first, second;  // persons; first < second
    int lab;
    const Pair *pair;  // of the authors that they are in this lab
    int is_turned;     // the pair's first author is the second person
} LabPair;

typedef struct TermPair {
    const LabPair *labs;  // n_labs of them, in the labs' order
    int n_labs;
    double score;  // the sum
} TermPair;

typedef struct AlikeTerm {
    Term term;
    Alike *labs;         // [term.n_labs]
    LabPair *lab_pairs;  // those of one pair of persons behind each other
    TermPair *pairs;     // the most alike first; behind those that are listed nothing of use
    int n_pairs;
    double level;  // a pair is listed from this sum on
    int n_listed;  // those at the beginning, PAIRS_LISTED at most
    const char *output;
} AlikeTerm;

// Read each lab, and add the scores of any two persons who are not one team in a lab. Returns 0, or
// -1 after one message on stderr. Release with alike_term_free() in either case.
int alike_term_read(const char *build, char *const *folders, int n_folders, AlikeTerm *all);
void alike_term_free(AlikeTerm *all);

// The page copies-term.html, and the same for programs. Return 0, or -1 after one message.
int copies_term_page(const AlikeTerm *all, const char *path);
int copies_term_json(const AlikeTerm *all, const char *path);

#endif
