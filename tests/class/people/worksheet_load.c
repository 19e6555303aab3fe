// Reading lists of participants (see worksheet.h). Read next: owners.c, which finds who is who.
#include "worksheet.h"

#include "list_columns.h"
#include "participant_fit.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

// The lines of the file, whose cells are the participants' from here on. Returns 0, or -1 after one
// message.
static int lines_read(Worksheet *worksheet)
{
    Sheet sheet;
    static const char expected[] =
        "a list of participants (Moodle, Canvas, Blackboard, Brightspace)";
    if (sheet_load(worksheet->path, expected, &sheet) != 0) {
        return -1;
    }
    worksheet->participants = calloc((size_t)sheet.n_lines, sizeof *worksheet->participants);
    if (worksheet->participants == NULL) {
        sheet_free(&sheet);
        return path_fault(worksheet->path, "out of memory");
    }
    worksheet->n_participants = sheet.n_lines;
    worksheet->n_columns = sheet.n_columns;
    worksheet->form = sheet.form;
    for (int i = 0; i < sheet.n_lines; i++) {
        memcpy(worksheet->participants[i].cells, sheet.lines[i].cells, sizeof sheet.lines[i].cells);
        sheet.lines[i] = (SheetLine){0};
    }
    sheet_free(&sheet);
    return 0;
}

// Of a file without any of the columns that we know nobody can be found in it.
static int persons_check(const Worksheet *worksheet)
{
    return has_persons(worksheet)
               ? 0
               : sheet_fault(worksheet->path, 1,
                             "found no column of names, user names, numbers or addresses, expected "
                             "one such as \"Full name\", \"Student\", \"Last Name\", "
                             "\"Username\", \"ID number\" or \"Email\"");
}

enum { N_KEYS = 4 };

// Do two lines have one number, login or address, and one name? Returns 1; 2: another name beside
// one number of Moodle's, which a system gives to one student; else 0.
//   keys   the columns; the first is the system's number; -1 where there is none
static int lines_repeat(const Worksheet *worksheet, const int keys[N_KEYS], const Participant *a,
                        const Participant *b)
{
    char name_a[ENTRY_NAME_BYTES], name_b[ENTRY_NAME_BYTES];
    int n_same = 0, n_other = 0, is_same_number = 0;
    for (int i = 0; i < N_KEYS; i++) {
        const char *key = cell_at(a, keys[i]), *other = cell_at(b, keys[i]);
        const int is_same = key[0] != '\0' && strcasecmp(key, other) == 0;
        n_same += is_same;
        n_other += !is_same && key[0] != '\0' && other[0] != '\0';
        is_same_number |= is_same && i == 0;
    }
    if (n_same == 0) {
        return 0;
    }
    participant_name(worksheet, a, name_a), participant_name(worksheet, b, name_b);
    return strcmp(name_a, name_b) == 0 ? n_other == 0 : 2 * is_same_number;
}

// A student who is in the list twice would be entered nowhere. Returns 0, or -1 after one message.
static int repeats_check(const Worksheet *worksheet)
{
    const int keys[N_KEYS] = {
        participant_column(worksheet, CELL_NUMBER), participant_column(worksheet, CELL_MAIL),
        participant_column(worksheet, CELL_SID), participant_column(worksheet, CELL_USER)};
    for (int i = 1; i < worksheet->n_participants; i++) {
        for (int k = 1; k < i; k++) {
            const int repeats = lines_repeat(worksheet, keys, &worksheet->participants[k],
                                             &worksheet->participants[i]);
            if (repeats != 0) {
                return sheet_fault(worksheet->path, i + 1,
                                   repeats == 1
                                       ? "the student of line %d again: delete one of the two lines"
                                       : "found the number of line %d under another name: correct "
                                         "one, or delete it",
                                   k + 1);
            }
        }
    }
    return 0;
}

// A grade is a part of the maximum: that has to be a number. Returns 0, or -1 after one message.
static int maxima_check(const Worksheet *worksheet)
{
    for (int i = 1; i < worksheet->n_participants; i++) {
        double most;
        char decimal;
        if (worksheet_maximum(worksheet, &worksheet->participants[i], 1, &most, &decimal) != 0 ||
            most <= 0 || most > 1e6) {
            const int column = worksheet->maximum_column;
            const int of_line = column >= 0 ? column : worksheet->grade_column;
            return sheet_fault(
                worksheet->path, column >= 0 ? i + 1 : 1,
                "\"%s\": found the maximum \"%s\", expected a number such as 100 or 1000.00",
                worksheet->participants[0].cells[of_line],
                column >= 0 ? worksheet->participants[i].cells[column] : worksheet->maximum);
        }
    }
    return 0;
}

int worksheet_load(const ListGiven *given, const char *lab, const Gradebook *gradebook,
                   Worksheet *worksheet)
{
    const char *path = given->path;
    *worksheet = (Worksheet){.path = path};
    worksheet->n_rows = gradebook->n_rows;
    worksheet->entered = calloc((size_t)gradebook->n_rows + 1, sizeof *worksheet->entered);
    if (worksheet->entered == NULL) {
        return path_fault(path, "out of memory");
    }
    if (lines_read(worksheet) != 0) {
        worksheet_free(worksheet);
        return -1;
    }
    worksheet->has_one_domain = has_one_domain(worksheet);
    if (persons_check(worksheet) != 0 || repeats_check(worksheet) != 0 ||
        list_columns_find(worksheet, given->column, lab != NULL ? atoi(lab) : -1) != 0 ||
        maxima_check(worksheet) != 0) {
        worksheet_free(worksheet);
        return -1;
    }
    return 0;
}
