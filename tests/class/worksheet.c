// Reading Moodle's lists (see worksheet.h). Read next: owners.c, which finds who is who.
#include "worksheet.h"

#include "complain.h"
#include "owners.h"
#include "sheet_number.h"
#include "sheet_text.h"

#include <csv.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

static int fault(const char *path, const char *what)
{
    complain("gradebook: %s: %s", path, what);
    return -1;
}

// ---- Columns ---------------------------------------------------------------------------------

// Titles as Moodle writes them in English and in German.
static const char *const grade_titles[] = {"Grade", "Bewertung", NULL};
static const char *const maximum_titles[] = {"Maximum Grade", "Maximum grade", "Bestwertung", NULL};

int worksheet_has_title(const Worksheet *worksheet, int column, const char *const *titles)
{
    const char *title = worksheet->participants[0].cells[column];
    while (*titles != NULL && strcmp(title, *titles) != 0) {
        titles++;
    }
    return *titles != NULL;
}

int worksheet_column(const Worksheet *worksheet, const char *const *titles)
{
    for (int i = 0; i < worksheet->n_columns; i++) {
        if (worksheet_has_title(worksheet, i, titles)) {
            return i;
        }
    }
    return -1;
}

// ---- Reading ---------------------------------------------------------------------------------

typedef struct Reader {
    Worksheet *worksheet;
    Participant current;
    int n_cells;
    const char *fault;
} Reader;

static void cell_read(void *field, size_t length, void *pointer)
{
    Reader *reader = pointer;
    (void)length;  // libcsv appends a NUL
    if (reader->n_cells == WORKSHEET_MAX_COLUMNS) {
        reader->fault = "a line has too many columns";
        return;
    }
    char *cell = strdup(field != NULL ? field : "");
    reader->current.cells[reader->n_cells++] = cell;
    reader->fault = cell == NULL ? "out of memory" : reader->fault;
}

static void line_end(int character, void *pointer)
{
    Reader *reader = pointer;
    Worksheet *worksheet = reader->worksheet;
    (void)character;
    const int n = worksheet->n_participants;
    if ((n & (n - 1)) == 0) {
        const size_t n_most = n > 0 ? 2 * (size_t)n : 1;
        Participant *grown = realloc(worksheet->participants, n_most * sizeof *grown);
        if (grown == NULL) {
            reader->fault = "out of memory";
            return;
        }
        worksheet->participants = grown;
    }
    if (n == 0) {
        worksheet->n_columns = reader->n_cells;
    } else if (reader->n_cells != worksheet->n_columns) {
        reader->fault = "a line has another number of columns than the first";
    }
    worksheet->participants[worksheet->n_participants++] = reader->current;
    reader->current = (Participant){0};
    reader->n_cells = 0;
}

static int text_parse(const char *bytes, size_t n_bytes, Worksheet *worksheet)
{
    struct csv_parser parser;
    Reader reader = {.worksheet = worksheet};
    SheetText sheet;
    const char *instead = sheet_text_find(bytes, n_bytes, &sheet);
    if (instead != NULL) {
        complain("gradebook: %s: found %s; expected Moodle's list of participants", worksheet->path,
                 instead);
        return -1;
    }
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);
    csv_set_delim(&parser, (unsigned char)sheet.delimiter);
    if (csv_parse(&parser, sheet.text, sheet.length, cell_read, line_end, &reader) !=
            sheet.length ||
        csv_fini(&parser, cell_read, line_end, &reader) != 0) {
        reader.fault = csv_strerror(csv_error(&parser));
    }
    csv_free(&parser);
    for (int i = 0; i < reader.n_cells; i++) {
        free(reader.current.cells[i]);
    }
    if (reader.fault == NULL && worksheet->n_participants == 0) {
        reader.fault = "empty; expected Moodle's list of participants";
    }
    return reader.fault != NULL ? fault(worksheet->path, reader.fault) : 0;
}

static int file_parse(Worksheet *worksheet)
{
    FILE *file = fopen(worksheet->path, "rb");
    char *text = file != NULL ? malloc(WORKSHEET_MAX_BYTES) : NULL;
    if (text == NULL) {
        const int result = fault(worksheet->path, strerror(errno));
        if (file != NULL) {
            fclose(file);
        }
        return result;
    }
    const size_t length = fread(text, 1, WORKSHEET_MAX_BYTES, file);
    int result = ferror(file) ? fault(worksheet->path, strerror(errno)) : 0;
    if (result == 0 && length == WORKSHEET_MAX_BYTES) {
        result = fault(worksheet->path, "too large for a list of participants");
    } else {
        text[length] = '\0';
    }
    result = result == 0 ? text_parse(text, length, worksheet) : result;
    fclose(file);
    free(text);
    return result;
}

// The maximum that a line has, and its decimal sign; the lab's, where it has none. Returns 0, or -1
// when there is something else.
static int maximum_read(const Worksheet *worksheet, const Participant *participant, int max_score,
                        double *most, char *decimal)
{
    const int column = worksheet->maximum_column;
    const char *cell = column >= 0 ? participant->cells[column] : "";
    *most = max_score;
    *decimal = '.';
    return *cell == '\0' ? 0 : sheet_number_read(cell, most, decimal);
}

// A grade is a part of the maximum: that has to be a number. Returns 0, or -1 after one message.
static int maxima_check(const Worksheet *worksheet)
{
    for (int i = 1; i < worksheet->n_participants; i++) {
        double most;
        char decimal;
        if (maximum_read(worksheet, &worksheet->participants[i], 1, &most, &decimal) != 0 ||
            most <= 0 || most > 1e6) {
            complain("gradebook: %s: line %d, \"%s\": found \"%s\", expected a number such as 100 "
                     "or 1000.00",
                     worksheet->path, i + 1,
                     worksheet->participants[0].cells[worksheet->maximum_column],
                     worksheet->participants[i].cells[worksheet->maximum_column]);
            return -1;
        }
    }
    return 0;
}

int worksheet_load(const char *path, const Gradebook *gradebook, Worksheet *worksheet)
{
    *worksheet = (Worksheet){.path = path};
    worksheet->n_rows = gradebook->n_rows;
    worksheet->entered = calloc((size_t)gradebook->n_rows + 1, sizeof *worksheet->entered);
    if (worksheet->entered == NULL) {
        return fault(path, "out of memory");
    }
    if (file_parse(worksheet) != 0) {
        worksheet_free(worksheet);
        return -1;
    }
    worksheet->grade_column = worksheet_column(worksheet, grade_titles);
    worksheet->maximum_column = worksheet_column(worksheet, maximum_titles);
    if (maxima_check(worksheet) != 0) {
        worksheet_free(worksheet);
        return -1;
    }
    if (owners_find(worksheet, gradebook) != 0) {
        worksheet_free(worksheet);
        return fault(path, "out of memory");
    }
    return 0;
}

void worksheet_free(Worksheet *worksheet)
{
    for (int i = 0; i < worksheet->n_participants; i++) {
        for (int c = 0; c < WORKSHEET_MAX_COLUMNS; c++) {
            free(worksheet->participants[i].cells[c]);
        }
    }
    free(worksheet->participants);
    for (int i = 0; i < worksheet->n_rows; i++) {
        free(worksheet->entered[i].why_not);
    }
    free(worksheet->entered);
    *worksheet = (Worksheet){0};
}

void worksheet_grade(const Worksheet *worksheet, const Participant *participant, int max_score,
                     char grade[32])
{
    double most;
    char decimal;
    maximum_read(worksheet, participant, max_score, &most, &decimal);
    snprintf(grade, 32, "%.2f", participant->row->score * most / max_score);
    char *point = strchr(grade, '.');
    if (point != NULL) {
        *point = decimal;
    }
}
