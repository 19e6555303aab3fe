// Cells of a CSV file that no spreadsheet takes for a formula.
#ifndef CLASS_CSV_CELL_H
#define CLASS_CSV_CELL_H

#include <stdio.h>

// Write a text in quotes. Wherever a formula could begin in it, by whatever sign a spreadsheet is
// told to part cells, it gets an apostrophe before the formula's sign.
void csv_cell_write(FILE *file, const char *text);

// The same for a cell of somebody else's table, in which a number or a lone "-" stays as it is.
void csv_cell_copy(FILE *file, const char *text);

#endif
