// The comments of an answer as forms: two people seldom write the same words, with the same slips.
#ifndef COPIES_REMARKS_H
#define COPIES_REMARKS_H

#include "forms.h"

// Add one form. Takes the text over; ends the program when memory runs out.
void forms_add(Forms *forms, FormKind kind, char *text, int first_line, int last_line);

// Add the comments of an answer. Short ones ("left child") say nothing: three words at least.
enum { REMARK_MIN_WORDS = 3 };
void remarks_read(const char *answer, Forms *forms);

#endif
