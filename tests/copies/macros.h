// The macros that an answer defines: what they stand for is as good as a statement of the answer.
//
//     #define EPSILON 1e-4f            EPSILON = 1e-4f
//     #define STEP(i) { i++; next(); } { i++; next(); }
#ifndef COPIES_MACROS_H
#define COPIES_MACROS_H

#include "expression.h"

typedef struct Macros {
    SourceWord *words;  // of all macros; behind each one a word of the kind SOURCE_END
    int n_words;
    NameSet in_place;  // names that can stand where a statement does: all that take parameters, or
                       // hold statements
    int n_statements;  // macros, and included files, that hide statements or names
} Macros;

// Read the macros of a text that must outlive them. Their names, and those of their parameters, are
// the answer's own, unless a macro stands for itself (#define dot dot). macros_free() them. Running
// out of memory ends the program.
Macros macros_read(const char *live, OwnNames *own);
void macros_free(Macros *macros);

#endif
