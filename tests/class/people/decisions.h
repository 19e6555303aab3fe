// Whose an entry is where names do not tell, and when it was handed in where nobody else can have
// written that: what the instructor decides, `WHO=`.
//
// Decisions come before all that owners.h finds by itself, and before what systems say of the time
// (late_times.c). The class offers the file, with a line for each entry that is to be decided. Read
// next: owners.h, called.h.
#ifndef CLASS_DECISIONS_H
#define CLASS_DECISIONS_H

#include "worksheet.h"

typedef enum DecisionKind {
    DECISION_YES,     // the entry is this participant's grade
    DECISION_NO,      // it is this participant's, but another one is the grade
    DECISION_IGNORE,  // it is nobody's
    DECISION_TIME,    // nothing about whose it is
} DecisionKind;

// A line of the file: entry, student, counts, handed in. Columns "name" and "reason" are for the
// reader.
typedef struct Decision {
    int line;         // in the file, the head being line 1
    int row;          // an index into gradebook->rows
    int participant;  // an index into worksheet->participants; 0: none
    DecisionKind kind;
    const char *student, *handed_in;  // as they were written, or ""
} Decision;

typedef struct Decisions {
    const char *path;
    Decision *all;  // as in the file; lines without a student, an answer or a time are left out
    int n;
    Sheet sheet;  // owns the texts
} Decisions;

// Read the instructor's decisions about a class.
//   worksheet   the list of participants; NULL: none was given, so lines can only say when
// Returns 0, or -1 after one message on stderr, where a line names no entry or two, no participant
// or two, an attempt of which a later one counts, no known answer, or contradicts another line.
// Release with decisions_free().
int decisions_load(const char *path, const Gradebook *gradebook, const Worksheet *worksheet,
                   Decisions *decisions);
void decisions_free(Decisions *decisions);

// "yes", "no", "ignore" or "": what the column "counts" has.
const char *decision_word(DecisionKind kind);

// Offer the file: FOLDER/who.csv with the decisions that were given, and a line for each entry that
// is to be decided yet. A file with other decisions in it is left as it is, with a message; without
// anything to decide there is no file.
//   n_open   out: how many are to be decided in the file; 0: it was not written
// Returns 0, or -1 after one message on stderr.
int decisions_offer(const Gradebook *gradebook, const Worksheet *worksheet, int *n_open);

#endif
