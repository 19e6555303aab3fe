// The gradebook: a row for each entry of the roster, in its order, and what they have in common.
//
// Results are read one at a time, and of each only what a row needs is kept. Nothing in it depends
// on the time, the engine or the order in which submissions were graded. Read next: gradebook.c.
#ifndef CLASS_GRADEBOOK_H
#define CLASS_GRADEBOOK_H

#include "graded.h"
#include "roster.h"

#include <stdint.h>
#include <stdio.h>

typedef enum RowStatus {
    ROW_GRADED,
    ROW_OUTDATED,    // graded, but the submission, the grader or the seed has changed since
    ROW_NOTHING,     // nothing of this lab was handed in: a zero or a blank, as the instructor says
    ROW_NOT_GRADED,  // a fault of the machinery: never a zero
} RowStatus;

typedef struct Row {
    const Entrant *entrant;
    int number;  // in the place of the name, on the page without names; else 0
    RowStatus status;
    char *reason;                    // why it is not graded, or what was handed in instead; or NULL
    int has_log;                     // logs/SLUG.txt tells more
    char *seed;                      // of the hidden scenes; NULL when not graded
    int score;                       // with corrections by hand, less what lateness costs
    int graded_score;                // as the grader gave it
    int points[MANIFEST_MAX_TASKS];  // with corrections
    int check_points[RESULT_MAX_CHECKS];   // without
    char passed[RESULT_MAX_CHECKS];        // check i of the gradebook passed
    char not_run[RESULT_MAX_CHECKS];       // or could not be run
    char is_open[RESULT_MAX_CHECKS];       // or its task stands as it was handed out
    char is_hidden[RESULT_MAX_CHECKS];     // what it finds is not for students
    char is_made_up[RESULT_MAX_CHECKS];    // the instructor gave all its points (corrections.h)
    char *causes[RESULT_MAX_CHECKS];       // its known mistake, a fixed sentence, or NULL
    char *said[RESULT_MAX_CHECKS];         // the first line of what it said; NULL: passed
    const char *found[RESULT_MAX_CHECKS];  // the same; NULL also where it was not run, or says
                                           // nothing about the answer
    char *stage, *stage_said;              // the first stage that failed, likewise; NULL: none
    // What went wrong first and still costs points (row_fault_find()); NULL: nothing.
    const char *fault;          // title of the stage or check
    const char *fault_id;       // the check's id, "" for a stage
    const char *fault_message;  // the first line of what it said
    int is_fault_hidden;        // which is not for students
    const char *picture;        // "picture.png" or "picture.svg" beside the report, or NULL
    double leaderboard;         // the figure of its race; 0: none
    const char *time_unknown;   // why nobody can say whether it was in time, or NULL (lateness.h)
    int has_old_score;
    int old_score;  // in the gradebook that this one is compared with
} Row;

typedef struct Gradebook {
    const char *folder;  // where students/SLUG/ and the three files are
    // Of the first result, which owns the texts. Its points and what it found mean nothing here.
    Graded first;
    const char *lab, *title;  // NULL when nothing was graded
    int max_score;
    const Column *tasks, *checks;
    int n_tasks, n_checks;
    char *leaderboard;  // what the rows' figures count; NULL where no row has one
    Row *rows;
    int n_rows;
    int n_graded;         // rows with a score
    int n_nothing;        // rows with nothing of this lab
    int nothing_is_zero;  // such a row is entered as 0; else its score stays blank
    int has_old_scores;   // there is something to compare with
    const struct Corrections *corrections;  // NULL: none were given (corrections.h)
    const struct Lateness *lateness;        // NULL: no deadline was given (lateness.h)
    const struct Decisions *decisions;      // NULL: none were given (decisions.h)
    int has_no_names;                       // rows have numbers: made for the page without names
    Roster roster;
} Gradebook;

// Gather the class: folder/roster.json, folder/keys (a line "SLUG KEY SEED" each, what is to be
// graded), and for each entrant folder/students/SLUG or the reason in folder/faults/SLUG.
//   against   an older gradebook.json of the same lab to compare with, or NULL
// Returns 0, or -1 after one message on stderr. Release with gradebook_free().
int gradebook_load(const char *folder, const char *against, Gradebook *gradebook);
// Is this an older gradebook of that lab, to compare with? Returns 0, or -1 after one message.
int gradebook_check_old(const char *against, const char *lab);
void gradebook_free(Gradebook *gradebook);

// The manifest of the class's lab, with the instructor's own points where there are any
// (points_tool.c). Returns 0, or -1 after one message. Release with manifest_free().
int gradebook_manifest(const Gradebook *gradebook, const char *lab, Manifest *manifest);

// Say on stderr what the gradebook.json that is there had and this run has not: corrections, late
// work. Forgotten options would change marks without a word.
void gradebook_tell_forgotten(const Gradebook *gradebook);

// "graded", "outdated", "nothing of this lab" or "not graded".
const char *row_status_name(RowStatus status);

// Of a student's attempts, which a host's export put below each other, the one that counts: the
// last with something of this lab, or the last of all.
const Row *row_that_counts(const Gradebook *gradebook, const Row *row);

// Find what went wrong first: in a stage, which keeps checks from running, or in a check. Beside a
// full score that is nothing, nor is it a check whose points an instructor gave all the same.
void row_fault_find(const Gradebook *gradebook, Row *row);

// Of a row that is one of several versions (versions.h): the first of them, and how many there are.
// Of any other row: itself, and 1.
const Row *row_versions(const Gradebook *gradebook, const Row *row, int *n);

// Was it graded? Only then its score counts in means and counts of passed checks.
int row_is_graded(const Row *row);

// Was it graded, and is it the attempt that counts? An earlier one is no other student's.
int row_is_counted(const Gradebook *gradebook, const Row *row);

// Does a row's score go into gradebooks? Not where nobody knows whether it was in time.
int row_is_entered(const Gradebook *gradebook, const Row *row);

#endif
