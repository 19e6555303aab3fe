// Telling what kind of file a list is (see sheet_text.h).
#include "sheet_text.h"

#include "utf8.h"

#include <string.h>
#include <strings.h>

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

// "sep=;" in a line of its own is for Excel, and says it all.
static char delimiter_take(SheetText *sheet)
{
    const char mark[] = "sep=";
    const size_t n_mark = sizeof mark - 1, n_line = line_length(sheet);
    if (n_line > n_mark && n_line <= n_mark + 2 && strncasecmp(sheet->text, mark, n_mark) == 0) {
        const char delimiter = sheet->text[n_mark];
        skip(sheet, n_line < sheet->length ? n_line + 1 : n_line);
        return delimiter;
    }
    // The head has the one of these that comes first in this order: Moodle itself writes commas.
    for (const char *sign = ",;\t"; *sign != '\0'; sign++) {
        if (memchr(sheet->text, *sign, n_line) != NULL) {
            return *sign;
        }
    }
    return ',';
}

const char *sheet_text_find(const char *bytes, size_t length, SheetText *sheet)
{
    *sheet = (SheetText){bytes, length, ','};
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
    }
    if (!is_utf8(sheet)) {
        return "no UTF-8; save it as CSV in UTF-8";
    }
    sheet->delimiter = delimiter_take(sheet);
    return NULL;
}
