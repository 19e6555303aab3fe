// What became of all entries: the last line of a class run, and its exit status.
#ifndef CLASS_TALLY_H
#define CLASS_TALLY_H

#include "worksheet.h"

// Each entry counts once, in the first of these that fits.
typedef struct Tally {
    int n_entries;
    int n_superseded;   // attempts of which a later one counts
    int n_not_graded;   // faults of the machinery
    int n_undecided;    // for some student not entered, or perhaps late
    int n_alike;        // without a list: groups of names that look alike
    int n_left_out;     // not to be counted, as the instructor decided
    int n_nothing;      // nothing of this lab was handed in
    int n_done;         // the rest: graded, and entered where there is a list
    int n_passed_over;  // files that are no entry
    int n_without;      // students of the list who handed in nothing
    int has_list;
} Tally;

//   worksheet   the list of participants, or NULL
//   n_alike     how many groups of names look like one person's
Tally tally_count(const Gradebook *gradebook, const Worksheet *worksheet, int n_alike);

// Why something of this row is to be decided by the instructor: whose it is, or whether it was in
// time. NULL: nothing is.
const char *tally_why_undecided(const Gradebook *gradebook, const Worksheet *worksheet,
                                const Row *row);

// Could somebody's work have been lost, should nobody look at the page?
int tally_has_lost(const Tally *tally);

// "20 of 23 graded and entered; 1 without submission; ...", without a newline.
void tally_write(FILE *file, const Tally *tally);

#endif
