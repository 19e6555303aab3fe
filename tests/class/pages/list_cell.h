// What we write into the cells of a list of participants, and what a row says in one.
//
// Read next: gradebook_csv.c; upload_csv.c, which writes the list alone.
#ifndef CLASS_LIST_CELL_H
#define CLASS_LIST_CELL_H

#include "worksheet.h"

#include <stdio.h>

// What a row says in a line: "60 of 100 points: leaf_loop 0/40, ...; Random scenes: found ...".
// Or that it was nothing of this lab, and what instead. Owned by the caller; NULL where the grader
// could not work.
#define COMMENT_NOTHING "nothing of this lab was found"
char *row_comment(const Gradebook *gradebook, const Row *row);

// Write what stands in a participant's cell: the grade in the column of grades, a comment in an
// empty one of comments, else what the list has. No formula (csv_cell.h).
void list_cell_write(FILE *file, const Worksheet *worksheet, const Participant *participant,
                     int column, const Gradebook *gradebook);

// Did the instructor, or the system, say in the cell that there is no grade for this student? Then
// it stays: Canvas' "EX" (excused) and "N/A" (not assigned).
int list_cell_is_excused(const Worksheet *worksheet, const char *cell);

#endif
