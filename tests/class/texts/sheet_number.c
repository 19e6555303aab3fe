// Reading a sheet's numbers (see sheet.h).
#include "sheet.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER_BYTES = 48 };

// Marks between groups of three digits that no decimals follow: blanks that break no line (U+00A0,
// U+202F), and apostrophes.
static const char *const group_marks[] = {" ", "\xC2\xA0", "\xE2\x80\xAF", "'", "\xE2\x80\x99"};

// The text with each such mark as one blank. Returns 0, or -1 when it is too long.
static int marks_unite(const char *text, char united[NUMBER_BYTES])
{
    size_t n = 0;
    while (*text != '\0') {
        size_t n_mark = 0;
        for (size_t i = 0; n_mark == 0 && i < sizeof group_marks / sizeof *group_marks; i++) {
            const size_t length = strlen(group_marks[i]);
            n_mark = strncmp(text, group_marks[i], length) == 0 ? length : 0;
        }
        if (n + 1 == NUMBER_BYTES) {
            return -1;
        }
        united[n++] = n_mark > 0 ? ' ' : *text;
        text += n_mark > 0 ? n_mark : 1;
    }
    united[n] = '\0';
    return 0;
}

// Keep the digits of the whole part: all of them digits, or groups of three behind one to three,
// all with the same mark. Returns 0, or -1.
static int groups_join(const char *whole, size_t length, char digits[NUMBER_BYTES])
{
    size_t n = 0, n_group = 0;
    char mark = '\0';
    for (size_t i = 0; i < length; i++) {
        if (isdigit((unsigned char)whole[i])) {
            digits[n++] = whole[i];
            n_group++;
            continue;
        }
        const int is_first = mark == '\0';
        if (strchr(" .,", whole[i]) == NULL || (!is_first && whole[i] != mark) || n_group == 0 ||
            n_group > 3 || (!is_first && n_group != 3)) {
            return -1;
        }
        mark = whole[i];
        n_group = 0;
    }
    digits[n] = '\0';
    return n > 0 && (mark == '\0' || n_group == 3) ? 0 : -1;
}

// Where the decimals begin: at the last point or comma, if it is the only one of its kind. NULL:
// there are none.
static const char *decimals_find(const char *text)
{
    const char *last = NULL;
    for (const char *at = text; *at != '\0'; at++) {
        last = *at == '.' || *at == ',' ? at : last;
    }
    return last != NULL && strchr(text, *last) == last ? last : NULL;
}

int sheet_number_read(const char *text, double *number, char *decimal)
{
    char united[NUMBER_BYTES], digits[2 * NUMBER_BYTES];
    if (marks_unite(text, united) != 0) {
        return -1;
    }
    const char *decimals = decimals_find(united);
    const size_t n_whole = decimals != NULL ? (size_t)(decimals - united) : strlen(united);
    if (groups_join(united, n_whole, digits) != 0) {
        return -1;
    }
    if (decimals != NULL) {
        const size_t n_decimals = strlen(decimals + 1);
        const int is_grouped = strcspn(united, " .,") < n_whole;
        // "1,000"; but "0,125" is no thousand.
        const int is_doubtful = n_decimals == 3 && !is_grouped && n_whole <= 3 && *united != '0';
        if (n_decimals == 0 || strspn(decimals + 1, "0123456789") != n_decimals || is_doubtful) {
            return -1;
        }
        snprintf(digits + strlen(digits), NUMBER_BYTES, ".%s", decimals + 1);
    }
    *number = strtod(digits, NULL);
    *decimal = decimals != NULL ? *decimals : '.';
    return 0;
}
