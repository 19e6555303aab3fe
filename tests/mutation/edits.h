// Edits of a text, written as in a patch without numbers of lines:
//
//     -    return distance <= radius;
//     +    return distance < radius;
//
// Lines with "-" stand in the text and go, lines with "+" come in their place, and lines with a
// blank stand there and stay: they say where, if the others are there twice or are none. A line
// without anything ends an edit. If all lines begin with "+", they are the new text.
//
// Used by known_answer.c.
#ifndef MUTATION_EDITS_H
#define MUTATION_EDITS_H

// Apply edits to a text. Each must fit in exactly one place, behind the one before it, and change
// something.
//   why, line   out, on failure: the reason, free() it; and the line of `edits` where the one at
//               fault begins, from 0
// Returns the new text, free() it, or NULL.
char *edits_apply(const char *text, const char *edits, char **why, int *line);

#endif
