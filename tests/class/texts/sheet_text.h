// What kind of file somebody exported, before it is read as a table.
#ifndef CLASS_SHEET_TEXT_H
#define CLASS_SHEET_TEXT_H

#include <stddef.h>

// In what form a table was written, to give it back in the same.
typedef struct SheetForm {
    char delimiter;     // a comma, a semicolon or a tab
    int has_mark;       // of UTF-8, at its beginning, or it was UTF-16
    int has_sep;        // a line "sep=;" before the head
    int has_dos_lines;  // they end with CR and LF
} SheetForm;

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
