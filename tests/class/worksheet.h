// Moodle's lists of participants, read and filled: the grading worksheet of an assignment, or the
// list of a course's participants.
//
// Flow: graded -> gradebook -> CSV. Read next: gradebook_csv.c.
#ifndef CLASS_WORKSHEET_H
#define CLASS_WORKSHEET_H

#include "gradebook.h"

enum { WORKSHEET_MAX_COLUMNS = 64, WORKSHEET_MAX_BYTES = 16 * 1024 * 1024 };

typedef struct Participant {
    char *cells[WORKSHEET_MAX_COLUMNS];
    const Row *row;  // the student's last entry, or NULL: handed in nothing
} Participant;

typedef struct Worksheet {
    const char *path;
    char delimiter;             // ',' or ';'
    Participant *participants;  // the first is the head, with the columns' titles
    int n_participants;
    int n_columns;
    int grade_column, maximum_column;  // -1 where there is none
    int *is_taken;                     // [n_rows] of the gradebook: stands beside a participant
} Worksheet;

// Read a list and find each participant's row of the gradebook: by Moodle's number, else by a name,
// a user name or an e-mail address that only one participant has. Returns 0, or -1 after one
// message on stderr. Release with worksheet_free().
int worksheet_load(const char *path, const Gradebook *gradebook, Worksheet *worksheet);
void worksheet_free(Worksheet *worksheet);

// What stands in the grade column: the score as a part of the sheet's maximum, with its decimal
// sign.
void worksheet_grade(const Worksheet *worksheet, const Participant *participant, int max_score,
                     char grade[32]);

#endif
