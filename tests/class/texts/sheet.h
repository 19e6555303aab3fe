// A CSV file that somebody exported or wrote, as lines of cells.
//
// Read next: worksheet.h, corrections.h, decisions.h, which say what the cells mean.
#ifndef CLASS_SHEET_H
#define CLASS_SHEET_H

#include <stddef.h>

enum { SHEET_MAX_COLUMNS = 256, SHEET_MAX_BYTES = 16 * 1024 * 1024 };

typedef struct SheetLine {
    char *cells[SHEET_MAX_COLUMNS];
} SheetLine;

// In what form a table was written, to give it back in the same.
typedef struct SheetForm {
    char delimiter;     // a comma, a semicolon or a tab
    int has_mark;       // of UTF-8, at its beginning, or it was UTF-16
    int has_sep;        // a line "sep=;" before the head
    int has_dos_lines;  // they end with CR and LF
} SheetForm;

typedef struct Sheet {
    SheetLine *lines;  // the first is the head, with the columns' titles; all have n_columns cells
    int n_lines;
    int n_columns;
    SheetForm form;
} Sheet;

// Read a file. Commas, semicolons or tabs part its cells (sheet_text_find()).
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

// Say what is wrong with a file or folder. Returns -1.
int path_fault(const char *path, const char *what);

// Read "100", "99.5", "99,50", "1,000.00", "1.000,00", "1 000,00" or "1'000.00", wholly: no sign,
// no unit. Of "1,000" nobody can say whether it is a thousand or one: it is none.
//   decimal   the sign before the decimals, '.' where there are none
// Returns 0, or -1 when the text is no such number.
int sheet_number_read(const char *text, double *number, char *decimal);

// ---- Before it is read as a table: what kind of file it is (sheet_text.c) ---------------------

typedef struct SheetText {
    const char *text;  // behind a byte order mark and a line "sep=;"
    size_t length;
    SheetForm form;
} SheetText;

// UTF-16 behind its mark as UTF-8 with a NUL behind it, owned by the caller: Blackboard and Excel
// write tables so. NULL: it is none, or damaged.
char *sheet_text_from_utf16(const char *bytes, size_t length, size_t *n_utf8);

// Find the table in a file's bytes, behind which is a NUL. Returns NULL, or what it is instead,
// with what to do, for a message: a workbook, a web page such as a login, text that is no UTF-8.
// The sign that parts cells is the most frequent one of the head, outside of quotes.
const char *sheet_text_find(const char *bytes, size_t length, SheetText *sheet);

#endif
