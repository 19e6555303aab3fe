// Telling what kind of file a list is (see sheet.h).
#include "sheet.h"

#include "utf8.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unicode/ustring.h>

static int begins_with(const SheetText *sheet, const char *start, size_t n_start)
{
    return sheet->length >= n_start && memcmp(sheet->text, start, n_start) == 0;
}

#define BEGINS_WITH(sheet, literal) begins_with(sheet, literal, sizeof(literal) - 1)

static void skip(SheetText *sheet, size_t n_bytes)
{
    sheet->text += n_bytes;
    sheet->length -= n_bytes;
}

static int is_web_page(SheetText sheet)
{
    while (sheet.length > 0 && strchr(" \t\r\n", *sheet.text) != NULL) {
        skip(&sheet, 1);
    }
    return sheet.length >= 5 &&
           (strncasecmp(sheet.text, "<!doc", 5) == 0 || strncasecmp(sheet.text, "<html", 5) == 0);
}

static int is_utf8(const SheetText *sheet)
{
    uint32_t character = 1;
    size_t i = 0;
    int n = 1;
    while (i < sheet->length && (n = utf8_read(sheet->text + i, &character)) > 0 && character > 0) {
        i += (size_t)n;
    }
    return i == sheet->length;
}

static size_t line_length(const SheetText *sheet)
{
    const char *end = memchr(sheet->text, '\n', sheet->length);
    return end != NULL ? (size_t)(end - sheet->text) : sheet->length;
}

// The sign that parts most cells of a line; of equally frequent ones the first, as Moodle itself
// writes commas.
static char most_frequent(const char *line, size_t n_line)
{
    static const char signs[] = ",;\t";
    int n[sizeof signs - 1] = {0}, is_quoted = 0, best = 0;
    for (size_t i = 0; i < n_line; i++) {
        const char *sign = strchr(signs, line[i]);
        is_quoted ^= line[i] == '"';
        if (!is_quoted && sign != NULL && *sign != '\0') {
            n[sign - signs]++;
        }
    }
    for (int i = 1; i < (int)sizeof signs - 1; i++) {
        best = n[i] > n[best] ? i : best;
    }
    return signs[best];
}

// "sep=;" in a line of its own is for Excel, and says it all.
static char delimiter_take(SheetText *sheet)
{
    const char mark[] = "sep=";
    const size_t n_mark = sizeof mark - 1, n_line = line_length(sheet);
    sheet->form.has_dos_lines = n_line > 0 && sheet->text[n_line - 1] == '\r';
    if (n_line > n_mark && n_line <= n_mark + 2 && strncasecmp(sheet->text, mark, n_mark) == 0) {
        sheet->form.has_sep = 1;
        const char delimiter = sheet->text[n_mark];
        skip(sheet, n_line < sheet->length ? n_line + 1 : n_line);
        return delimiter;
    }
    return most_frequent(sheet->text, n_line);
}

char *sheet_text_from_utf16(const char *bytes, size_t length, size_t *n_utf8)
{
    const SheetText text = {.text = bytes, .length = length};
    const int is_little = BEGINS_WITH(&text, "\xFF\xFE");
    if ((!is_little && !BEGINS_WITH(&text, "\xFE\xFF")) || length % 2 != 0) {
        return NULL;
    }
    const size_t n_units = length / 2 - 1, n_most = 3 * n_units + 1;
    UChar *units = malloc(n_units * sizeof *units + 1);
    char *utf8 = malloc(n_most);
    for (size_t i = 0; units != NULL && i < n_units; i++) {
        const unsigned char *pair = (const unsigned char *)bytes + 2 + 2 * i;
        units[i] = (UChar)(pair[!is_little] | pair[is_little] << 8);
    }
    UErrorCode status = U_ZERO_ERROR;
    int32_t n = 0;
    if (units != NULL && utf8 != NULL) {
        u_strToUTF8(utf8, (int32_t)n_most, &n, units, (int32_t)n_units, &status);
    }
    free(units);
    if (utf8 == NULL || units == NULL || U_FAILURE(status)) {
        free(utf8);
        return NULL;
    }
    *n_utf8 = (size_t)n;
    return utf8;
}

const char *sheet_text_find(const char *bytes, size_t length, SheetText *sheet)
{
    *sheet = (SheetText){.text = bytes, .length = length};
    if (BEGINS_WITH(sheet, "\xFF\xFE") || BEGINS_WITH(sheet, "\xFE\xFF")) {
        return "UTF-16; save it as CSV in UTF-8";
    }
    if (BEGINS_WITH(sheet, "PK\3\4") || BEGINS_WITH(sheet, "\xD0\xCF\x11\xE0")) {
        return "a workbook (Excel or LibreOffice), or an archive; save it as CSV";
    }
    if (is_web_page(*sheet)) {
        return "a web page, perhaps a login; download the list again";
    }
    if (BEGINS_WITH(sheet, "\xEF\xBB\xBF")) {
        skip(sheet, 3);  // a byte order mark
        sheet->form.has_mark = 1;
    }
    if (!is_utf8(sheet)) {
        return "no UTF-8; save it as CSV in UTF-8";
    }
    sheet->form.delimiter = delimiter_take(sheet);
    return NULL;
}
