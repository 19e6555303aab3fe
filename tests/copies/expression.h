// An expression of C or OpenCL C as one text that is the same however it was written: without names
// of the author's own, without needless brackets, operands in one order.
//
//     a > b          <(b,a)          i++, i += 1     =(_,+(1,_))
//     x - 2.0f * y   +(-(*(2,y)),x)  (b + a)         +(a,b)
//
// Never trusted: what is no expression gives some text, too. Read next: forms.h.
#ifndef COPIES_EXPRESSION_H
#define COPIES_EXPRESSION_H

#include "form_list.h"
#include "source_words.h"

// The names that an answer declares: each is written "_", so that renaming them changes nothing.
typedef struct OwnNames {
    NameSet names;
    NameSet called;        // of these, functions and macros
    const NameSet *given;  // what the lab declares around the hole, never own names; NULL: none
    int is_full;           // there were more names than OWN_NAMES_MAX
} OwnNames;

// Add one; a name that is given is passed by.
enum { OWN_NAMES_MAX = 20000 };
void own_names_add(OwnNames *own, const SourceWord *name, int is_called);

// Is it one of them? A variable's name is not where it is called: so declaring a variable "dot"
// does not make every dot() one's own.
int own_names_have(const OwnNames *own, const SourceWord *word, int is_called);

void own_names_free(OwnNames *own);

// The form of words[from] up to words[to], which is not in it. If there are more words than this
// many, or the form is longer than this, it is the words in their order, and *is_cut becomes 1.
// free() it; running out of memory ends the program.
enum { EXPRESSION_MAX_WORDS = 1000, EXPRESSION_MAX_BYTES = 4096 };
char *expression_form(const SourceWord words[], int from, int to, const OwnNames *own, int *is_cut);

// Does a name look like a type's: one of the language, with or without a width (float3), or one
// that begins with a capital and has small letters (TodoEntry)?
int is_type_name(const SourceWord *word);

// Is it a word that may stand before a type and says nothing about what is computed?
int is_qualifier(const SourceWord *word);

#endif
