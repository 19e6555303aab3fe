// gradebook.csv: the class for spreadsheets (see gradebook.h).
//
// Cells are quoted by libcsv. One that a spreadsheet would take for a formula begins with an
// apostrophe. Read next: worksheet.h, Moodle's columns.
#include "gradebook.h"

#include "output_file.h"

#include <csv.h>
#include <string.h>

static void cell_write(FILE *file, const char *text, const char *end)
{
    char defused[2048];
    if (text[0] != '\0' && strchr("=+-@\t\r", text[0]) != NULL) {
        snprintf(defused, sizeof defused, "'%s", text);
        text = defused;
    }
    csv_fwrite(file, text, strlen(text));
    fputs(end, file);
}

static void number_write(FILE *file, int number, const char *end)
{
    fprintf(file, "%d%s", number, end);
}

static void head_write(FILE *file, const Gradebook *gradebook)
{
    fputs("\"name\",\"number\",\"attempt\",\"status\",\"score\",\"max\",", file);
    for (int i = 0; i < gradebook->n_tasks; i++) {
        cell_write(file, gradebook->tasks[i].id, ",");
    }
    fputs("\"first fault\",\"report\"\n", file);
}

static void row_write(FILE *file, const Gradebook *gradebook, const Row *row)
{
    cell_write(file, row->entrant->name, ",");
    cell_write(file, row->entrant->number, ",");
    number_write(file, row->entrant->attempt, ",");
    cell_write(file, row_status_name(row->status), ",");
    if (row->status == ROW_NOT_GRADED) {
        for (int i = 0; i < gradebook->n_tasks + 2; i++) {
            fputc(',', file);
        }
        cell_write(file, row->reason, ",\n");
        return;
    }
    char report[128];
    snprintf(report, sizeof report, "students/%s/report.html", row->entrant->slug);
    number_write(file, row->score, ",");
    number_write(file, gradebook->max_score, ",");
    for (int i = 0; i < gradebook->n_tasks; i++) {
        number_write(file, row->points[i], ",");
    }
    cell_write(file, row->fault != NULL ? row->fault : "", ",");
    cell_write(file, report, "\n");
}

int gradebook_csv(const Gradebook *gradebook, const char *path, const char *worksheet)
{
    (void)worksheet;
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    head_write(output.file, gradebook);
    for (int i = 0; i < gradebook->n_rows; i++) {
        row_write(output.file, gradebook, &gradebook->rows[i]);
    }
    return output_file_commit(&output);
}
