// Reading CSV files (see sheet.h).
#include "sheet.h"

#include "complain.h"

#include <csv.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int path_fault(const char *path, const char *what)
{
    complain("gradebook: %s: %s", path, what);
    return -1;
}

int sheet_fault(const char *path, int line, const char *format, ...)
{
    char reason[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reason, sizeof reason, format, arguments);
    va_end(arguments);
    complain("gradebook: %s: line %d: %s", path, line, reason);
    return -1;
}

typedef struct Reader {
    Sheet *sheet;
    SheetLine current;
    int n_cells;
    const char *fault;  // of the first line that has one
    int fault_line;
} Reader;

static void reader_fault(Reader *reader, const char *fault)
{
    if (reader->fault == NULL) {
        reader->fault = fault;
        reader->fault_line = reader->sheet->n_lines + 1;
    }
}

static void cell_read(void *field, size_t length, void *pointer)
{
    Reader *reader = pointer;
    (void)length;  // libcsv appends a NUL
    if (reader->n_cells == SHEET_MAX_COLUMNS) {
        reader_fault(reader, "found too many columns");
        return;
    }
    char *cell = strdup(field != NULL ? field : "");
    reader->current.cells[reader->n_cells++] = cell;
    if (cell == NULL) {
        reader_fault(reader, "out of memory");
    }
}

static void line_end(int character, void *pointer)
{
    Reader *reader = pointer;
    Sheet *sheet = reader->sheet;
    (void)character;
    const int n = sheet->n_lines;
    if ((n & (n - 1)) == 0) {
        const size_t n_most = n > 0 ? 2 * (size_t)n : 1;
        SheetLine *grown = realloc(sheet->lines, n_most * sizeof *grown);
        if (grown == NULL) {
            reader_fault(reader, "out of memory");
            return;
        }
        sheet->lines = grown;
    }
    if (n == 0) {
        sheet->n_columns = reader->n_cells;
    } else if (reader->n_cells != sheet->n_columns) {
        reader_fault(reader, "found another number of columns than in the first");
    }
    sheet->lines[sheet->n_lines++] = reader->current;
    reader->current = (SheetLine){0};
    reader->n_cells = 0;
}

static int text_parse(const char *path, const char *expected, const char *bytes, size_t n_bytes,
                      Sheet *sheet)
{
    struct csv_parser parser;
    Reader reader = {.sheet = sheet};
    SheetText found;
    const char *instead = sheet_text_find(bytes, n_bytes, &found);
    if (instead != NULL) {
        complain("gradebook: %s: found %s; expected %s", path, instead, expected);
        return -1;
    }
    sheet->form = found.form;
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);
    csv_set_delim(&parser, (unsigned char)found.form.delimiter);
    if (csv_parse(&parser, found.text, found.length, cell_read, line_end, &reader) !=
            found.length ||
        csv_fini(&parser, cell_read, line_end, &reader) != 0) {
        reader_fault(&reader, csv_strerror(csv_error(&parser)));
    }
    csv_free(&parser);
    for (int i = 0; i < reader.n_cells; i++) {
        free(reader.current.cells[i]);
    }
    if (reader.fault == NULL && sheet->n_lines == 0) {
        complain("gradebook: %s: empty; expected %s", path, expected);
        return -1;
    }
    if (reader.fault != NULL) {
        complain("gradebook: %s: line %d: %s", path, reader.fault_line, reader.fault);
        return -1;
    }
    return 0;
}

int sheet_load(const char *path, const char *expected, Sheet *sheet)
{
    *sheet = (Sheet){0};
    FILE *file = fopen(path, "rb");
    char *text = file != NULL ? malloc(SHEET_MAX_BYTES) : NULL;
    if (text == NULL) {
        const int result = path_fault(path, strerror(errno));
        if (file != NULL) {
            fclose(file);
        }
        return result;
    }
    int is_utf16 = 0;
    size_t length = fread(text, 1, SHEET_MAX_BYTES, file);
    int result = ferror(file) ? path_fault(path, strerror(errno)) : 0;
    if (result == 0 && length == SHEET_MAX_BYTES) {
        complain("gradebook: %s: too large for %s", path, expected);
        result = -1;
    } else {
        char *utf8 = sheet_text_from_utf16(text, length, &length);
        if (utf8 != NULL) {
            free(text);
            text = utf8;
            is_utf16 = 1;
        }
        text[length] = '\0';
    }
    result = result == 0 ? text_parse(path, expected, text, length, sheet) : result;
    sheet->form.has_mark |= is_utf16;
    fclose(file);
    free(text);
    if (result != 0) {
        sheet_free(sheet);
    }
    return result;
}

void sheet_free(Sheet *sheet)
{
    for (int i = 0; i < sheet->n_lines; i++) {
        for (int c = 0; c < SHEET_MAX_COLUMNS; c++) {
            free(sheet->lines[i].cells[c]);
        }
    }
    free(sheet->lines);
    *sheet = (Sheet){0};
}

// The titles in a row, "student, task, points", for a message.
static void titles_join(const char *const *titles, int n_titles, char *joined, size_t n_joined)
{
    size_t length = 0;
    for (int i = 0; i < n_titles && length < n_joined; i++) {
        length += (size_t)snprintf(joined + length, n_joined - length, "%s%s", i > 0 ? ", " : "",
                                   titles[i]);
    }
}

int sheet_columns_find(const Sheet *sheet, const char *path, const char *const *titles,
                       int n_titles, int n_needed, int *columns)
{
    char all[256];
    titles_join(titles, n_titles, all, sizeof all);
    for (int i = 0; i < n_titles; i++) {
        columns[i] = -1;
    }
    for (int c = 0; c < sheet->n_columns; c++) {
        const char *title = sheet->lines[0].cells[c];
        int i = 0;
        while (i < n_titles && strcmp(title, titles[i]) != 0) {
            i++;
        }
        if (i == n_titles || columns[i] >= 0) {
            complain("gradebook: %s: line 1: found the column \"%s\"%s, expected these: %s", path,
                     title, i < n_titles ? " twice" : "", all);
            return -1;
        }
        columns[i] = c;
    }
    for (int i = 0; i < n_needed; i++) {
        if (columns[i] < 0) {
            complain("gradebook: %s: line 1: found no column \"%s\", expected these: %s", path,
                     titles[i], all);
            return -1;
        }
    }
    return 0;
}

int sheet_line_is_empty(const Sheet *sheet, const SheetLine *line)
{
    for (int c = 0; c < sheet->n_columns; c++) {
        if (line->cells[c][0] != '\0') {
            return 0;
        }
    }
    return 1;
}
