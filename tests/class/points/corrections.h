// Corrections by hand: points, comments and extensions that the instructor gives, `CHANGES=`.
//
// They are read at every run, and applied to what the grader found, so that they outlive a new
// grading. The grader's own points stay beside them. Read next: corrections.c, called.h.
#ifndef CLASS_CORRECTIONS_H
#define CLASS_CORRECTIONS_H

#include "worksheet.h"

// In the place of a task: the score as a whole, whose tasks keep their points.
#define SCORE "score"

// A line of the file: student, task (or a check's id), points, comment, until.
typedef struct Correction {
    int line;        // in the file, the head being line 1
    const Row *row;  // whose it is; NULL: of the participant, who handed in nothing
    const Participant *participant;
    char *task;         // a task's id, or SCORE; NULL: only a comment or an extension
    char *check;        // of that task; NULL: the task as a whole
    int max_points;     // of the check or the task
    int has_points;     // is a number of points given?
    int is_relative;    // "+5", "-5"
    int points;         // as given
    int is_applied;     // the row's points are changed; else there were none to change
    int before, after;  // then: of the check or the task
    char *comment;      // fit for one line, or ""
    const char *until;  // an extension's last day, "2026-12-24", or ""
} Correction;

typedef struct Corrections {
    const char *path;
    const Worksheet *worksheet;  // the list of participants, or NULL
    Correction *all;             // as in the file
    int n;
    Sheet sheet;  // owns the texts
} Corrections;

// Read a file of corrections for a class of this lab ("03-kdtree-2d-render").
// Returns 0, or -1 after one message on stderr, where a line names nobody or two, an unknown task
// or check, points beyond what they can earn, no day, or what another line corrects. Release with
// corrections_free().
int corrections_load(const char *path, const char *lab, const Gradebook *gradebook,
                     const Worksheet *worksheet, Corrections *corrections);
void corrections_free(Corrections *corrections);

// Change the points of the rows that have any, and make the corrections the gradebook's. Returns 0,
// or -1 after one message on stderr, where "+5" or "-5" leads beyond what can be earned: then no
// row is changed.
int corrections_apply(Corrections *corrections, Gradebook *gradebook);

// The correction behind `before` (NULL: the first) of a row, or, if that is NULL, of a participant.
// NULL: there is none.
const Correction *corrections_next(const Gradebook *gradebook, const Row *row,
                                   const Participant *participant, const Correction *before);

// Has a row a correction? And how many corrections of points had none to change?
int corrections_has(const Gradebook *gradebook, const Row *row);
int corrections_count_waiting(const Gradebook *gradebook);

// The corrections of a row, or where that is NULL of a participant, in a line, not escaped:
// "gradient: 40 to 45 (+5): right idea; ...". Nothing where there is none.
void corrections_write(FILE *file, const Gradebook *gradebook, const Row *row,
                       const Participant *participant);

// The last day of their extensions; "" where there is none.
const char *corrections_until(const Gradebook *gradebook, const Row *row,
                              const Participant *participant);

// What one changes, "gradient: 40 to 45 (+5)"; nothing where it names no task.
void correction_change_write(FILE *file, const Correction *correction);

#endif
