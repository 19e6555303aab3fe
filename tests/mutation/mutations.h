// Mutations: small mechanical mistakes in a text of C or OpenCL, to see whether the judge notices.
//
// A mutation's id is "position:operator:old:new", position being the number of the word, old and
// new what stands there before and after ("17:compare:<:<="); it depends on nothing but the text.
// Used by mutate.c.
#ifndef GRADER_MUTATIONS_H
#define GRADER_MUTATIONS_H

#include <stddef.h>

enum { MUTATION_ID_BYTES = 96 };

// One edit: `length` bytes from `start` on become `replacement`.
typedef struct Mutation {
    char id[MUTATION_ID_BYTES];
    size_t start;
    size_t length;
    char *replacement;
} Mutation;

typedef struct Mutations {
    Mutation *all;  // [n], in the order of the text
    int n;
} Mutations;

// Find every mutation of a text. Operators:
//   operator  + and -, * and /, && and ||, & and |, ++ and --, += and -=, ...; no sign before one
//   compare   each comparison moved by its border and turned round
//   constant  a number one up, one down, doubled, zero; INFINITY as zero; NAMED plus one
//   swap      neighbours in a list of arguments or in an initialiser
//   drop      a statement left out, or all of a block
//   negate    the condition of if, while, for and ?:
//   name      x for y, min for max, near for far and the like
//   unwrap    f(a) as (a)
// Not every one compiles, and some change nothing that counts. Returns 0, or -1 when memory runs
// out. Release with mutations_free().
int mutations_find(const char *text, Mutations *mutations);
void mutations_free(Mutations *mutations);

// The text with the one edit. free() it; NULL when memory runs out.
char *mutation_apply(const char *text, const Mutation *mutation);

#endif
