// gradebook.csv: the class for spreadsheets and for Moodle (see gradebook.h).
//
// Cells are quoted by libcsv. One that a spreadsheet would take for a formula begins with an
// apostrophe; what Moodle wrote itself goes back as it came. Read next: worksheet.h.
#include "gradebook.h"

#include "output_file.h"
#include "worksheet.h"

#include <csv.h>
#include <string.h>

static void quoted_write(FILE *file, const char *text)
{
    csv_fwrite(file, text, strlen(text));
}

static void cell_write(FILE *file, char delimiter, const char *text)
{
    char defused[2048];
    if (text[0] != '\0' && strchr("=+-@\t\r", text[0]) != NULL) {
        snprintf(defused, sizeof defused, "'%s", text);
        text = defused;
    }
    fputc(delimiter, file);
    quoted_write(file, text);
}

// ---- Our columns: each begins with a delimiter but the first --------------------------------

static void titles_write(FILE *file, char delimiter, const Gradebook *gradebook)
{
    static const char *const titles[] = {"number", "attempt", "status", "score", "max"};
    quoted_write(file, "name");
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++) {
        cell_write(file, delimiter, titles[i]);
    }
    for (int i = 0; i < gradebook->n_tasks; i++) {
        cell_write(file, delimiter, gradebook->tasks[i].id);
    }
    cell_write(file, delimiter, "first fault");
    cell_write(file, delimiter, "report");
    fputc('\n', file);
}

static void empty_write(FILE *file, char delimiter, int n_cells)
{
    for (int i = 0; i < n_cells; i++) {
        fputc(delimiter, file);
    }
}

// A row, or for NULL that nothing was handed in.
static void row_write(FILE *file, char delimiter, const Gradebook *gradebook, const Row *row)
{
    if (row == NULL) {
        empty_write(file, delimiter, 2);
        cell_write(file, delimiter, "no submission");
        empty_write(file, delimiter, gradebook->n_tasks + 4);
        fputc('\n', file);
        return;
    }
    // The first cell of a line has no delimiter before it.
    const char *name = row->entrant->name;
    char defused[ENTRY_NAME_BYTES + 1];
    snprintf(defused, sizeof defused, "%s%s", strchr("=+-@", name[0]) != NULL ? "'" : "", name);
    quoted_write(file, name[0] != '\0' ? defused : "");
    cell_write(file, delimiter, row->entrant->number);
    fprintf(file, "%c%d", delimiter, row->entrant->attempt);
    cell_write(file, delimiter, row_status_name(row->status));
    if (row->status == ROW_NOT_GRADED) {
        empty_write(file, delimiter, gradebook->n_tasks + 2);
        cell_write(file, delimiter, row->reason);
        fprintf(file, "%c\n", delimiter);
        return;
    }
    char report[128];
    snprintf(report, sizeof report, "students/%s/report.html", row->entrant->slug);
    fprintf(file, "%c%d%c%d", delimiter, row->score, delimiter, gradebook->max_score);
    for (int i = 0; i < gradebook->n_tasks; i++) {
        fprintf(file, "%c%d", delimiter, row->points[i]);
    }
    cell_write(file, delimiter, row->fault != NULL ? row->fault : "");
    cell_write(file, delimiter, report);
    fputc('\n', file);
}

// ---- Moodle's columns ------------------------------------------------------------------------

static void participant_write(FILE *file, const Worksheet *worksheet,
                              const Participant *participant, const Gradebook *gradebook)
{
    const Row *row = participant->row;
    for (int i = 0; i < worksheet->n_columns; i++) {
        char grade[32];
        const char *cell = participant->cells[i];
        if (i == worksheet->grade_column && row != NULL && row->status != ROW_NOT_GRADED) {
            worksheet_grade(worksheet, participant, gradebook->max_score, grade);
            cell = grade;
        }
        quoted_write(file, cell);
        fputc(worksheet->delimiter, file);
    }
    row_write(file, worksheet->delimiter, gradebook, row);
}

// The list with its grades filled in; then who is not in it, and earlier attempts.
static int worksheet_write(FILE *file, const Gradebook *gradebook, const char *path)
{
    Worksheet worksheet;
    if (worksheet_load(path, gradebook, &worksheet) != 0) {
        return -1;
    }
    for (int i = 0; i < worksheet.n_columns; i++) {
        quoted_write(file, worksheet.participants[0].cells[i]);
        fputc(worksheet.delimiter, file);
    }
    titles_write(file, worksheet.delimiter, gradebook);
    for (int i = 1; i < worksheet.n_participants; i++) {
        participant_write(file, &worksheet, &worksheet.participants[i], gradebook);
    }
    for (int i = 0; i < gradebook->n_rows; i++) {
        if (!worksheet.is_taken[i]) {
            empty_write(file, worksheet.delimiter, worksheet.n_columns);
            row_write(file, worksheet.delimiter, gradebook, &gradebook->rows[i]);
        }
    }
    worksheet_free(&worksheet);
    return 0;
}

int gradebook_csv(const Gradebook *gradebook, const char *path, const char *worksheet)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    if (worksheet != NULL) {
        if (worksheet_write(output.file, gradebook, worksheet) != 0) {
            output_file_discard(&output);
            return -1;
        }
        return output_file_commit(&output);
    }
    titles_write(output.file, ',', gradebook);
    for (int i = 0; i < gradebook->n_rows; i++) {
        row_write(output.file, ',', gradebook, &gradebook->rows[i]);
    }
    return output_file_commit(&output);
}
