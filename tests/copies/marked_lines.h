// An answer's lines for the page: which few others have, and which are shown.
#ifndef COPIES_MARKED_LINES_H
#define COPIES_MARKED_LINES_H

#include "alike.h"

typedef struct MarkedLine {
    char *text;     // in MarkedLines.text
    int n_authors;  // of the rarest form at this line that both have, or 0 if none is rare
    int is_shown;
} MarkedLine;

typedef struct MarkedLines {
    char *text;  // owned
    MarkedLine *all;
    int n;
} MarkedLines;

// The lines of an answer that is there, with the forms that both authors of a pair and no more than
// a quarter of the class have. Of a long answer only what is near such forms is shown, and of a run
// of empty lines only the first. marked_lines_free() them. Running out of memory ends the program.
MarkedLines marked_lines(const Alike *alike, const Pair *pair, const Answer *answer);
void marked_lines_free(MarkedLines *lines);

#endif
