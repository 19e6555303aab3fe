// What a compiler does not see of an answer, as forms: two people seldom write the same words, with
// the same slips, or hit the space bar twice at the same place.
#ifndef COPIES_REMARKS_H
#define COPIES_REMARKS_H

#include "expression.h"
#include "forms.h"

// Add the comments of an answer, and its odd blanks: at the end of a line, before ; and , or
// several between two words. Short comments ("left child") say nothing: three words at least.
enum { REMARK_MIN_WORDS = 3 };
void remarks_read(const char *answer, const OwnNames *own, Forms *forms);

#endif
