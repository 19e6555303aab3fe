// The list of participants with the grades in it, for the system that wrote it, and nothing else: a
// line or a column more would be a student or an assignment more there.
//
// Read next: upload_csv.c; gradebook_csv.c, whose file has all that we know besides.
#ifndef CLASS_UPLOAD_CSV_H
#define CLASS_UPLOAD_CSV_H

#include "worksheet.h"

#include <stdio.h>

// Write what stands in a participant's cell: the grade in the column of grades, a comment in an
// empty one of comments, else what the list has. No formula (csv_cell.h).
void list_cell_write(FILE *file, const Worksheet *worksheet, const Participant *participant,
                     int column, const Gradebook *gradebook);

// Did the instructor, or the system, say in the cell that there is no grade for this student? Then
// it stays: Canvas' "EX" (excused) and "N/A" (not assigned).
int list_cell_is_excused(const Worksheet *worksheet, const char *cell);

// Write the file, where the list has a column of grades. Returns 0, or -1 after one message.
int upload_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet);

#endif
