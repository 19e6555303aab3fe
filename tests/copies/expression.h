// An expression of C or OpenCL C as one text that is the same however it was written: without names
// of the author's own, without needless brackets, operands in one order.
//
//     a > b          <(b,a)          i++, i += 1     =(_,+(1,_))
//     x - 2.0f * y   +(-(*(2,y)),x)  (b + a)         +(a,b)
//
// Never trusted: what is no expression gives some text, too. Read next: forms.h.
#ifndef COPIES_EXPRESSION_H
#define COPIES_EXPRESSION_H

#include "source_words.h"

// The names that an answer declares: each is written "_", so that renaming them changes nothing.
typedef struct OwnNames {
    char **names;
    int n;
} OwnNames;

// Is it one of them?
int own_names_have(const OwnNames *own, const SourceWord *word);

// The form of words[from] up to words[to], which is not in it. Longer ones than this many words
// keep their order. free() it; running out of memory ends the program.
enum { EXPRESSION_MAX_WORDS = 1000 };
char *expression_form(const SourceWord words[], int from, int to, const OwnNames *own);

// Does a name look like a type's: one of the language, with or without a width (float3), or one
// that begins with a capital and has small letters (TodoEntry)?
int is_type_name(const SourceWord *word);

// Is it a word that may stand before a type and says nothing about what is computed?
int is_qualifier(const SourceWord *word);

#endif
