// Defusing formulas (see csv_cell.h).
//
// Quotes keep a cell together only where the file is read with the sign that it was written with: a
// spreadsheet that parts at semicolons, as is usual in half of Europe, sees the line
//     "x;=1+1;b","100"
// fall into three cells. So a formula may begin wherever one of the usual signs stands. Used by
// gradebook_csv.c.
#include "csv_cell.h"

#include <csv.h>
#include <stdlib.h>
#include <string.h>

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

// What may part cells or lines.
static int is_separator(char byte)
{
    return byte != '\0' && strchr(",;\t|\r\n", byte) != NULL;
}

// What a reader may pass over at the beginning of a cell: quotes, as only the first one of a cell
// counts, and blanks of any width. Returns its length, or 0.
static size_t passed_over_length(const char *text)
{
    static const char *const blanks[] = {
        " ",
        "\"",
        "\xC2\xA0",      // U+00A0, no break
        "\xE3\x80\x80",  // U+3000, ideographic
        "\xE2\x80\xAF",  // U+202F, narrow
        "\xEF\xBB\xBF",  // U+FEFF, a byte order mark
        NULL,
    };
    // U+2000 to U+200B, of all widths down to none.
    const int is_space =
        strncmp(text, "\xE2\x80", 2) == 0 && (unsigned char)text[2] - 0x80u <= 0x0B;
    return is_space ? 3 : word_length(text, blanks);
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
        is_beginning = is_separator(*text) || (is_beginning && passed_over > 0);
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
