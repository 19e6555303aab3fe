// The forms of an answer: what each of its statements comes to when names, order and spelling are
// taken away, and what else of a text can be alike (its comments, its own names, odd blanks).
//
//     const uint left = nodes[id].lChild;            "=(_,.([](nodes,id),lChild))" and "uint"
//     for (uint i = 0; i < n; i++)                   "=(_,0)", "loop <(_,n)", "=(_,+(1,_))"
//     if (x < a.minX) { ... }                        "if <(x,.(_,minX))"
//
// So a loop is the same with `for` and `while`. An answer's forms are a set: where a statement
// stands says nothing. Read next: weights.h.
#ifndef COPIES_FORMS_H
#define COPIES_FORMS_H

#include "form_list.h"

typedef enum FormKind {
    FORM_STATEMENT,
    FORM_COMMENT,
    FORM_NAME,    // one that the answer declares
    FORM_BLANKS,  // blanks where nobody expects them
} FormKind;

typedef struct Form {
    FormKind kind;
    char *text;      // owned; of a comment its words in small letters
    int first_line;  // where it stands in the answer, from 1
    int last_line;
    int id;  // see weights.h
} Form;

typedef struct Forms {
    Form *all;  // in the order of the answer
    int n;
    int n_different;
    int n_words;           // that were read
    int n_left_out;        // words that no compiler reads, or that never run: #if 0, if (0) { }
    int n_conditional;     // words between directives of which nobody can tell whether they hold
    int n_with_directive;  // macros that stand for statements, and included files
    int is_cut;            // there was more than the limits allow (FORMS_MAX, expression.h)
    void *seen;            // see forms_add.c
} Forms;

// Read the forms of the text in a hole. Of more different ones than this many only the first.
//   given   names that the lab declares around the hole (scope.h), or NULL: an answer that declares
//           them once more does not make them its own
// forms_free() them. Running out of memory ends the program.
enum { FORMS_MAX = 20000 };
Forms forms_read(const char *answer, const NameSet *given);
void forms_free(Forms *forms);

#endif
