// A course's list of participants, read and filled: Moodle's grading worksheet, the gradebook that
// Canvas, Blackboard or Brightspace export, or any other list with names, numbers or addresses.
//
// Read next: list_columns.h, whose list it is; gradebook_csv.c and upload_csv.h, which fill it.
#ifndef CLASS_WORKSHEET_H
#define CLASS_WORKSHEET_H

#include "gradebook.h"
#include "sheet.h"

// The system that wrote it.
typedef enum ListSystem {
    LIST_OTHER,  // names, numbers or addresses of whatever source
    LIST_MOODLE,
    LIST_CANVAS,
    LIST_BLACKBOARD,
    LIST_BRIGHTSPACE,
    N_LIST_SYSTEMS
} ListSystem;

typedef struct Participant {
    char *cells[SHEET_MAX_COLUMNS];
    const Row *row;    // the student's entry that counts, or NULL: none, or not for certain
    int is_nobody;     // the line is about no person
    int is_contested;  // entries of two names fit: then none counts
    int is_fitted;     // an entry is, or may be, the student's, whether it counts or not
} Participant;

// What became of a row of the gradebook.
typedef struct Entered {
    int n_participants;    // beside whom it is: all of a team; none if a later attempt counts
    char *why_not;         // who it could not be entered for, and why; NULL: nobody
    const char *left_out;  // the instructor decided so, in these words; NULL: no
} Entered;

enum { WORKSHEET_MAXIMUM_BYTES = 48 };

typedef struct Worksheet {
    const char *path;
    ListSystem system;
    SheetForm form;
    Participant *participants;  // the first is the head, with the columns' titles
    int n_participants;
    int n_columns;
    int grade_column, maximum_column;       // -1 where there is none
    char maximum[WORKSHEET_MAXIMUM_BYTES];  // of all lines; "": that of the line's own column
    char is_uploaded[SHEET_MAX_COLUMNS];    // which columns the system reads again (upload_csv.h)
    int has_one_domain;                     // all e-mail addresses are of one
    Entered *entered;                       // [n_rows] of the gradebook
    int n_rows;
} Worksheet;

// Where a list is, and what the instructor says of it.
typedef struct ListGiven {
    const char *path;
    const char *column;  // that takes the grades (list_columns.h), or NULL
} ListGiven;

// Read a list. Whose the rows of the gradebook are, is found by owners.h.
//   lab   that was or will be graded, "03-kdtree-2d-render"; NULL: nothing was
// Returns 0, or -1 after one message on stderr. Release with worksheet_free().
int worksheet_load(const ListGiven *given, const char *lab, const Gradebook *gradebook,
                   Worksheet *worksheet);
void worksheet_free(Worksheet *worksheet);

// Has a column one of these titles, a list that ends with NULL, in small letters or capitals? And
// the first column that has, or -1.
int worksheet_has_title(const Worksheet *worksheet, int column, const char *const *titles);
int worksheet_column(const Worksheet *worksheet, const char *const *titles);

// The maximum that a line has, and its decimal sign; the lab's, where it has none. Returns 0, or -1
// when there is something else.
int worksheet_maximum(const Worksheet *worksheet, const Participant *participant, int max_score,
                      double *most, char *decimal);

// What stands in the grade column: the score as a part of the sheet's maximum, with its decimal
// sign.
void worksheet_grade(const Worksheet *worksheet, const Participant *participant, int max_score,
                     char grade[32]);

#endif
