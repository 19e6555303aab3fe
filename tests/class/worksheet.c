// Reading Moodle's lists and finding who is who (see worksheet.h).
#include "worksheet.h"

#include "complain.h"

#include <csv.h>
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int fault(const char *path, const char *what)
{
    complain("gradebook: %s: %s", path, what);
    return -1;
}

// ---- Columns ---------------------------------------------------------------------------------

// Titles as Moodle writes them in English and in German.
static const char *const number_titles[] = {"Identifier", "ID", NULL};
static const char *const grade_titles[] = {"Grade", "Bewertung", NULL};
static const char *const maximum_titles[] = {"Maximum Grade", "Maximum grade", "Bestwertung", NULL};
static const char *const first_titles[] = {"First name", "Vorname", NULL};
static const char *const last_titles[] = {"Surname", "Last name", "Nachname", NULL};
static const char *const name_titles[] = {"Full name",      "Vollständiger Name", "Email address",
                                          "E-Mail-Adresse", "Username",           "Anmeldename",
                                          "ID number",      "ID-Nummer",          "Matrikelnummer",
                                          "GitHub",         "GitHub username",    NULL};

static int is_one_of(const char *title, const char *const *titles)
{
    while (*titles != NULL && strcmp(title, *titles) != 0) {
        titles++;
    }
    return *titles != NULL;
}

static int column_find(const Worksheet *worksheet, const char *const *titles)
{
    for (int i = 0; i < worksheet->n_columns; i++) {
        if (is_one_of(worksheet->participants[0].cells[i], titles)) {
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

// A spreadsheet may have parted it by semicolons; Moodle itself writes and takes commas.
static char delimiter_of(const char *text, size_t length)
{
    const char *end = memchr(text, '\n', length);
    const size_t n_head = end != NULL ? (size_t)(end - text) : length;
    return memchr(text, ',', n_head) == NULL && memchr(text, ';', n_head) != NULL ? ';' : ',';
}

static int text_parse(const char *text, size_t length, Worksheet *worksheet)
{
    struct csv_parser parser;
    Reader reader = {.worksheet = worksheet};
    if (length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0) {
        text += 3, length -= 3;  // a byte order mark
    }
    csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI | CSV_APPEND_NULL);
    csv_set_delim(&parser, (unsigned char)delimiter_of(text, length));
    if (csv_parse(&parser, text, length, cell_read, line_end, &reader) != length ||
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
    }
    result = result == 0 ? text_parse(text, length, worksheet) : result;
    fclose(file);
    free(text);
    return result;
}

// ---- Who is who ------------------------------------------------------------------------------

// "Participant 1234567" and "1234567" are the number 1234567.
static int has_number(const char *cell, const char *number)
{
    const size_t length = strlen(cell);
    const size_t n_digits = strlen(number);
    return n_digits > 0 && length >= n_digits && strcmp(cell + length - n_digits, number) == 0 &&
           (length == n_digits || !isdigit((unsigned char)cell[length - n_digits - 1]));
}

// Is the cell this name, or an e-mail address that begins with it?
static int is_name(const char *cell, const char *name)
{
    const size_t length = strlen(name);
    return length > 0 && strncmp(cell, name, length) == 0 &&
           (cell[length] == '\0' || (cell[length] == '@' && strchr(name, '@') == NULL));
}

static int is_called(const Worksheet *worksheet, const Participant *participant, const char *name)
{
    for (int i = 0; i < worksheet->n_columns; i++) {
        if (is_one_of(worksheet->participants[0].cells[i], name_titles) &&
            is_name(participant->cells[i], name)) {
            return 1;
        }
    }
    const int first = column_find(worksheet, first_titles);
    const int last = column_find(worksheet, last_titles);
    if (first < 0 || last < 0) {
        return 0;
    }
    const size_t n_first = strlen(participant->cells[first]);
    return strncmp(name, participant->cells[first], n_first) == 0 && name[n_first] == ' ' &&
           strcmp(name + n_first + 1, participant->cells[last]) == 0;
}

// The one participant who handed a row's entry in, or NULL.
static Participant *owner_find(const Worksheet *worksheet, const Entrant *entrant)
{
    const int number_column = column_find(worksheet, number_titles);
    Participant *owner = NULL;
    int n_owners = 0;
    for (int i = 1; i < worksheet->n_participants; i++) {
        Participant *participant = &worksheet->participants[i];
        if (number_column >= 0 && has_number(participant->cells[number_column], entrant->number)) {
            return participant;
        }
        if (is_called(worksheet, participant, entrant->name)) {
            owner = participant;
            n_owners++;
        }
    }
    return n_owners == 1 ? owner : NULL;
}

int worksheet_load(const char *path, const Gradebook *gradebook, Worksheet *worksheet)
{
    *worksheet = (Worksheet){.path = path};
    worksheet->is_taken = calloc((size_t)gradebook->n_rows + 1, sizeof *worksheet->is_taken);
    if (worksheet->is_taken == NULL) {
        return fault(path, "out of memory");
    }
    if (file_parse(worksheet) != 0) {
        worksheet_free(worksheet);
        return -1;
    }
    worksheet->grade_column = column_find(worksheet, grade_titles);
    worksheet->maximum_column = column_find(worksheet, maximum_titles);
    for (int i = 0; i < gradebook->n_rows; i++) {
        Participant *owner = owner_find(worksheet, gradebook->rows[i].entrant);
        if (owner != NULL) {
            // Rows of one student come in the order of attempts: the last one counts.
            if (owner->row != NULL) {
                worksheet->is_taken[owner->row - gradebook->rows] = 0;
            }
            owner->row = &gradebook->rows[i];
            worksheet->is_taken[i] = 1;
        }
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
    free(worksheet->is_taken);
    *worksheet = (Worksheet){0};
}

void worksheet_grade(const Worksheet *worksheet, const Participant *participant, int max_score,
                     char grade[32])
{
    const int column = worksheet->maximum_column;
    char maximum[32];
    snprintf(maximum, sizeof maximum, "%s", column >= 0 ? participant->cells[column] : "");
    char *comma = strchr(maximum, ',');
    if (comma != NULL) {
        *comma = '.';
    }
    double most = strtod(maximum, NULL);
    most = isfinite(most) && most > 0 && most < 1e6 ? most : max_score;
    snprintf(grade, 32, "%.2f", participant->row->score * most / max_score);
    char *point = strchr(grade, '.');
    if (comma != NULL && point != NULL) {
        *point = ',';
    }
}
