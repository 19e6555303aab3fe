// A CSV file that somebody exported or wrote, as lines of cells.
//
// Read next: worksheet.h, corrections.h, decisions.h, which say what the cells mean.
#ifndef CLASS_SHEET_H
#define CLASS_SHEET_H

#include "sheet_text.h"

enum { SHEET_MAX_COLUMNS = 256, SHEET_MAX_BYTES = 16 * 1024 * 1024 };

typedef struct SheetLine {
    char *cells[SHEET_MAX_COLUMNS];
} SheetLine;

typedef struct Sheet {
    SheetLine *lines;  // the first is the head, with the columns' titles; all have n_columns cells
    int n_lines;
    int n_columns;
    SheetForm form;
} Sheet;

// Read a file. Commas, semicolons or tabs part its cells (sheet_text.h).
//   expected   what it has to be, for messages: "Moodle's list of participants"
// Returns 0, or -1 after one message on stderr. Release with sheet_free().
int sheet_load(const char *path, const char *expected, Sheet *sheet);
void sheet_free(Sheet *sheet);

// Find the columns of a file that an instructor writes: columns[i] is the one with titles[i], or -1
// where there is none. A title that is none of them may be a slip, and is refused.
//   n_needed   so many of the titles, the first ones, must be there
// Returns 0, or -1 after one message on stderr.
int sheet_columns_find(const Sheet *sheet, const char *path, const char *const *titles,
                       int n_titles, int n_needed, int *columns);

// One message about a line, the head being line 1. Returns -1.
__attribute__((format(printf, 3, 4))) int sheet_fault(const char *path, int line,
                                                      const char *format, ...);

// Has a line no text in any cell?
int sheet_line_is_empty(const Sheet *sheet, const SheetLine *line);

#endif
