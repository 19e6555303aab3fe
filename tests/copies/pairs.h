// How alike the answers of any two authors are, over all tasks together.
//
// What two authors share weighs as much as all forms of it (weights.h). Among many pairs some are
// alike by chance, so a pair is listed only from a level on that grows with their number. Nor is it
// listed if better pairs connect the two already: five with one text make four pairs and not ten.
#ifndef COPIES_PAIRS_H
#define COPIES_PAIRS_H

#include "weights.h"

typedef struct Pair {
    int first, second;  // authors; first < second
    double nats;        // what the forms weigh that both have
    double share;       // of what the one's weigh who has less, 0 to 1
    double score;       // nats * share: by it pairs are ordered
    int n_shared;       // forms of some weight that both have
    int n_only_two;     // of these, how many nobody else has
} Pair;

// The ids of an author's forms, each once, ascending.
typedef struct Ids {
    int *all;
    int n;
    double nats;  // what all weigh
} Ids;

enum { PAIRS_KEPT = 1000, PAIRS_LISTED = 30, PAIRS_MIN_AUTHORS = 3 };

typedef struct Pairs {
    Pair *all;  // the most alike first, PAIRS_KEPT at most
    int n;
    int n_compared;
    double level;  // a pair is listed from this score on
    int n_listed;  // those at the beginning, PAIRS_LISTED at most
    Ids *ids;      // of each author
    int n_authors;
    int n_tellable;  // authors whose forms weigh as much as the level: a second text would be seen
} Pairs;

// Compare any two authors. Release with pairs_free(). Running out of memory ends the program.
void pairs_find(const HandedIn *class, const Weights *weights, Pairs *pairs);
void pairs_free(Pairs *pairs);

// Are the answers of this class so short, or so much what everybody writes, that the list says
// nothing? True where fewer than a quarter are tellable, or where there are too few authors.
int pairs_are_too_few(const HandedIn *class, const Pairs *pairs);

// Groups of those whom pairs connect: start with each in a group of its own.
int *groups_make(int n);
// Connect two. Returns 1, or 0 where others connect them already.
int groups_connect(int *groups, int n, int first, int second);

// Does an author have the form with this id? Quick, as it is asked for every form of every pair.
int author_has(const Pairs *pairs, int author, int id);

#endif
