// Answers that are hard to compare: what the program reads of them may not be all that they do.
#ifndef COPIES_HARD_H
#define COPIES_HARD_H

#include "alike.h"

#include <stdio.h>

// Why an author's answers are hard to compare, for people; free() it. NULL if they are not.
char *hard_reason(const Alike *alike, const Author *author);

// How many authors' are.
int hard_count(const Alike *alike);

// The page's section with these authors, and with the entries that could not be read; nothing if
// there are none.
void hard_write(FILE *page, const Alike *alike);

#endif
