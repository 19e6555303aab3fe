// The answers of two authors beside each other, with a sign before each line that few others have.
#ifndef COPIES_SIDE_BY_SIDE_H
#define COPIES_SIDE_BY_SIDE_H

#include "alike.h"

#include <stdio.h>

// What being alike can mean, and who gets the page.
void side_by_side_reasons(FILE *page);

// The heading of all pairs, with what the signs mean.
void side_by_side_begin(FILE *page);

// An author's name, linked to the report where there is one.
void author_name_write(FILE *page, const Alike *alike, const Author *author);

// Inside of a card, in an open "<div class=title><b>": both names, then what they share, then their
// answers task by task.
void side_by_side_write(FILE *page, const Alike *alike, const Pair *pair);

#endif
