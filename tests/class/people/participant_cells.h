// What a list of participants says of each: which column is which, by its title.
//
// Read next: participant_fit.h, which compares.
#ifndef CLASS_PARTICIPANT_CELLS_H
#define CLASS_PARTICIPANT_CELLS_H

#include "entry_name.h"
#include "worksheet.h"

// What a column may say. tests/INSTRUCTORS.md lists the titles for a list of one's own.
typedef enum CellKind {
    CELL_NUMBER,  // the course system's number, "Participant 12"
    CELL_GROUP,
    CELL_FIRST,
    CELL_LAST,
    CELL_NAME,  // the whole name
    CELL_MAIL,
    CELL_SID,   // the university's number
    CELL_USER,  // a login
    N_CELL_KINDS
} CellKind;

// The first column of a kind, or -1. A column "Name" has last names beside a column of first names,
// unless there is one of last names; else it has whole names.
int participant_column(const Worksheet *worksheet, CellKind kind);

// Is a column one of a kind by its title?
int column_is(const Worksheet *worksheet, int column, CellKind kind);

// A participant's cell in the first column of a kind, or in this column; "" where there is none.
const char *participant_cell(const Worksheet *worksheet, const Participant *participant,
                             CellKind kind);
const char *cell_at(const Participant *participant, int column);

// A number or login without the "#" that Brightspace puts before it.
const char *plain_key(const char *key);

// The forms of a full name that a list may give: as one, or from two columns. Each may be "".
typedef struct FullNames {
    char text[3][512];
} FullNames;
FullNames full_names(const Worksheet *worksheet, const Participant *participant);

// What the list says of a participant: the full name; the course system's number; the e-mail
// address; the university's number, without "#". "" where there is none.
void participant_name(const Worksheet *worksheet, const Participant *participant,
                      char name[ENTRY_NAME_BYTES]);
const char *participant_number(const Worksheet *worksheet, const Participant *participant);
const char *participant_address(const Worksheet *worksheet, const Participant *participant);
const char *participant_sid(const Worksheet *worksheet, const Participant *participant);

// Has the list a column by which a person can be found?
int has_persons(const Worksheet *worksheet);

#endif
