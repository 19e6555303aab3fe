// What the forms of an answer are made of, for forms.c alone.
#ifndef COPIES_FORMS_PARTS_H
#define COPIES_FORMS_PARTS_H

#include "expression.h"
#include "forms.h"

// ---- Collecting them (forms_add.c) -----------------------------------------------------------

// Add one form, but no empty one. Takes the text over. The same form counts once against FORMS_MAX,
// and is kept at FORM_PLACES lines at most. Running out of memory ends the program.
enum { FORM_PLACES = 100 };
void forms_add(Forms *forms, FormKind kind, char *text, int first_line, int last_line);

// No form will be added: release what tells them apart.
void forms_complete(Forms *forms);

// ---- The text that a compiler reads, without what stands in #if 0 (live_text.c) ---------------

// How much of a text there is to compare, in words.
typedef struct LiveCount {
    int n_left_out;     // in branches that are never compiled
    int n_conditional;  // in branches of other conditions, which are kept, all of them
} LiveCount;

// A copy of the answer with empty lines for what no compiler reads: what follows `#if 0`, or an
// `#else` or `#elif` behind `#if 1`. Lines keep their numbers. free() it. Running out of memory
// ends the program.
char *live_text(const char *answer, LiveCount *count);

// ---- Macros: what they stand for is as good as a statement (macros.c) -------------------------
//
//     #define EPSILON 1e-4f            EPSILON = 1e-4f
//     #define STEP(i) { i++; next(); } { i++; next(); }

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

// ---- What no compiler sees (remarks.c) --------------------------------------------------------
//
// Two people seldom write the same words, with the same slips, or hit the space bar twice at the
// same place.

// Add the comments of an answer, and its odd blanks: at the end of a line, before ; and , or
// several between two words. Short comments ("left child") say nothing: three words at least.
enum { REMARK_MIN_WORDS = 3 };
void remarks_read(const char *answer, const OwnNames *own, Forms *forms);

#endif
