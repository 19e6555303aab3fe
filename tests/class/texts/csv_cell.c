// Defusing formulas (see csv_cell.h).
//
// Quotes keep a cell together only where the file is read with the sign that it was written with: a
// spreadsheet that parts at semicolons, as is usual in half of Europe, sees the line
//     "x;=1+1;b","100"
// fall into three cells. So a formula may begin wherever one of the usual signs stands. Used by
// gradebook_csv.c.
#include "csv_cell.h"

#include "name_likeness.h"
#include "utf8.h"

#include <csv.h>
#include <stdlib.h>
#include <string.h>
#include <unicode/uchar.h>

// The length of the first of `words` that text begins with, or 0.
static size_t word_length(const char *text, const char *const *words)
{
    for (; *words != NULL; words++) {
        const size_t length = strlen(*words);
        if (strncmp(text, *words, length) == 0) {
            return length;
        }
    }
    return 0;
}

// The signs that a formula begins with: East Asian spreadsheets take the full-width and the small
// ones, too, and the minus sign of typography is one to some.
static int is_formula_sign(const char *text)
{
    static const char *const signs[] = {
        "=",  "+",  "-",  "@",         // and U+FF1D, U+FF0B, U+FF0D, U+FF20
        "＝", "＋", "－", "＠", "﹦",  // U+FE66
        "﹢", "﹣", "﹫", "−",  NULL,  // U+FE62, U+FE63, U+FE6B, U+2212
    };
    return word_length(text, signs) > 0;
}

// What may part cells or lines: of blanks those that are no mere space.
static int is_separator(const char *text)
{
    uint32_t code = 0;
    utf8_read(text, &code);
    return (code != 0 && code < 0x80 && strchr(",;|", (char)code) != NULL) ||
           (u_isUWhiteSpace((UChar32)code) && u_charType((UChar32)code) != U_SPACE_SEPARATOR);
}

// What a reader may pass over at the beginning of a cell: quotes, as only the first one of a cell
// counts, characters of which there is nothing to see, and accents, which have no letter there.
// Returns its length, or 0.
static size_t passed_over_length(const char *text)
{
    uint32_t code = 0;
    const int length = utf8_read(text, &code);
    const int is_passed_over = code == '"' || character_is_blank(code) ||
                               (U_GET_GC_MASK((UChar32)code) & U_GC_M_MASK) != 0;
    return length > 0 && is_passed_over ? (size_t)length : 0;
}

void csv_cell_write(FILE *file, const char *text)
{
    char *defused = malloc(2 * strlen(text) + 1);
    size_t n = 0;
    int is_beginning = 1;
    if (defused == NULL) {
        fputs("\"\"", file);
        return;
    }
    while (*text != '\0') {
        if (is_beginning && is_formula_sign(text)) {
            defused[n++] = '\'';
        }
        const size_t passed_over = passed_over_length(text);
        is_beginning = is_separator(text) || (is_beginning && passed_over > 0);
        const size_t length = passed_over > 0 ? passed_over : 1;
        memcpy(defused + n, text, length);
        n += length;
        text += length;
    }
    csv_fwrite(file, defused, n);
    free(defused);
}

// A number as spreadsheets of any country write it.
static int is_number(const char *text)
{
    const size_t n_signs = text[0] == '-' || text[0] == '+';
    return strspn(text + n_signs, "0123456789.,") == strlen(text + n_signs);
}

void csv_cell_copy(FILE *file, const char *text)
{
    if (is_number(text)) {
        csv_fwrite(file, text, strlen(text));
    } else {
        csv_cell_write(file, text);
    }
}
