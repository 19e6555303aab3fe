// What kind of file somebody exported, before it is read as a table.
#ifndef CLASS_SHEET_TEXT_H
#define CLASS_SHEET_TEXT_H

#include <stddef.h>

typedef struct SheetText {
    const char *text;  // behind a byte order mark and a line "sep=;"
    size_t length;
    char delimiter;  // a comma, a semicolon or a tab
} SheetText;

// Find the table in a file's bytes, behind which is a NUL. Returns NULL, or what it is instead,
// with what to do, for a message: a workbook, a web page such as a login, text that is no UTF-8.
const char *sheet_text_find(const char *bytes, size_t length, SheetText *sheet);

#endif
