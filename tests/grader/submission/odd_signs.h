// Characters in a source that look like others, or like nothing: a compiler's error at them is a
// riddle, as the line looks right.
#ifndef GRADER_ODD_SIGNS_H
#define GRADER_ODD_SIGNS_H

#include <stdio.h>

// Look for them in a text, outside of its comments, strings and characters. Write a line for each
// to `notes`, with the line of `name` and the code point, but for no more than a few. Returns how
// many it found.
int odd_signs_note(const char *name, const char *text, FILE *notes);

#endif
