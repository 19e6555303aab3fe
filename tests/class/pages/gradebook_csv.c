// gradebook.csv: the class for spreadsheets, behind the columns of a list (see gradebook.h).
//
// No cell is a formula (csv_cell.h), not even the list's: a student may choose the own name there.
// A system knows its lines again by a number or a user name. Read next: worksheet.h.
#include "class_page.h"

#include "complain.h"
#include "corrections.h"
#include "csv_cell.h"
#include "lateness.h"
#include "list_cell.h"
#include "moment.h"
#include "output_file.h"
#include "sheet.h"
#include "tally.h"
#include "worksheet.h"

#include <stdlib.h>
#include <string.h>

static void cell_write(FILE *file, const char *text)
{
    fputc(',', file);
    csv_cell_write(file, text);
}

// ---- Our columns: each begins with a comma but the first -------------------------------------

static void empty_write(FILE *file, int n_cells)
{
    for (int i = 0; i < n_cells; i++) {
        fputc(',', file);
    }
}

// The end of a line, with one more cell where `last` is not NULL.
static void row_end(FILE *file, const char *last)
{
    if (last != NULL) {
        cell_write(file, last);
    }
    fputc('\n', file);
}

// `last`: the title of a column after them, or NULL.
static void titles_write(FILE *file, const Gradebook *gradebook, const char *last)
{
    static const char *const titles[] = {"number", "attempt", "status", "score", "max"};
    csv_cell_write(file, "name");
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++) {
        cell_write(file, titles[i]);
    }
    for (int i = 0; i < gradebook->n_tasks; i++) {
        cell_write(file, gradebook->tasks[i].id);
    }
    cell_write(file, "first fault");
    cell_write(file, "report");
    if (gradebook->corrections != NULL || gradebook->lateness != NULL) {
        cell_write(file, "score before");
    }
    if (gradebook->corrections != NULL) {
        cell_write(file, "corrections");
        cell_write(file, "more time until");
    }
    if (gradebook->lateness != NULL) {
        cell_write(file, "handed in");
        cell_write(file, "late");
        cell_write(file, "points off");
    }
    row_end(file, last);
}

// What the grader gave, where the score is another one now.
static void score_before_write(FILE *file, const Gradebook *gradebook, const Row *row)
{
    if (gradebook->corrections == NULL && gradebook->lateness == NULL) {
        return;
    }
    if (row != NULL && row->score != row->graded_score) {
        fprintf(file, ",%d", row->graded_score);
    } else {
        empty_write(file, 1);
    }
}

// How it was corrected: of a row, or where that is NULL of a participant. Nothing where no
// corrections were given.
static void corrections_cells_write(FILE *file, const Gradebook *gradebook, const Row *row,
                                    const Participant *participant)
{
    if (gradebook->corrections == NULL) {
        return;
    }
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    if (stream != NULL) {
        corrections_write(stream, gradebook, row, participant);
        fclose(stream);
    }
    cell_write(file, text != NULL ? text : "");
    cell_write(file, corrections_until(gradebook, row, participant));
    free(text);
}

// When it was handed in, how late, and what that costs. Nothing where no deadline was given.
static void late_cells_write(FILE *file, const Gradebook *gradebook, const Row *row)
{
    const LateRow *late = row != NULL ? lateness_of(gradebook, row) : NULL;
    char handed_in[MOMENT_BYTES] = "", by[LATENESS_BYTES] = "";
    if (gradebook->lateness == NULL) {
        return;
    }
    if (late == NULL || (!late->has_time && !late->is_marked)) {
        empty_write(file, 1);
        cell_write(file, late != NULL && late->unknown != NULL ? "unknown" : "");
        empty_write(file, 1);
        return;
    }
    if (late->has_time) {
        moment_stamp(late->handed_in, handed_in);
        lateness_duration(late->seconds, by);
    }
    cell_write(file, handed_in);
    cell_write(file, late->is_marked ? "yes" : late->seconds > 0 ? by : "");
    fprintf(file, ",%d", late->off);
}

// Behind our columns what has changed their points.
static void changes_cells_write(FILE *file, const Gradebook *gradebook, const Row *row,
                                const Participant *participant)
{
    score_before_write(file, gradebook, row);
    corrections_cells_write(file, gradebook, row, participant);
    late_cells_write(file, gradebook, row);
}

// What stands in the place of a participant's row where there is none: why.
static void no_row_write(FILE *file, const Gradebook *gradebook, const Participant *participant,
                         const char *why)
{
    empty_write(file, 2);
    cell_write(file, why);
    empty_write(file, gradebook->n_tasks + 4);
    changes_cells_write(file, gradebook, NULL, participant);
    row_end(file, "");
}

// `last` as in titles_write().
static void row_write(FILE *file, const Gradebook *gradebook, const Row *row, const char *last)
{
    // The first cell has no comma before it.
    csv_cell_write(file, row->entrant->name);
    cell_write(file, row->entrant->number);
    fprintf(file, ",%d", row->entrant->attempt);
    cell_write(file, row_status_name(row->status));
    if (row_is_entered(gradebook, row)) {
        fprintf(file, ",%d,%d", row->score, gradebook->max_score);
    } else {
        empty_write(file, 2);
    }
    for (int i = 0; i < gradebook->n_tasks; i++) {
        if (row_is_graded(row)) {
            fprintf(file, ",%d", row->points[i]);
        } else {
            empty_write(file, 1);
        }
    }
    const char *fault = row->reason != NULL ? row->reason : row->fault;
    cell_write(file, fault != NULL ? fault : "");
    if (row->status == ROW_NOT_GRADED) {
        empty_write(file, 1);
    } else {
        char report[128];
        snprintf(report, sizeof report, "students/%s/report.html", row->entrant->slug);
        cell_write(file, report);
    }
    changes_cells_write(file, gradebook, row, NULL);
    row_end(file, last);
}

// ---- The list's columns ----------------------------------------------------------------------

static void participant_write(FILE *file, const Worksheet *worksheet,
                              const Participant *participant, const Gradebook *gradebook)
{
    const Row *row = participant->row;
    for (int i = 0; i < worksheet->n_columns; i++) {
        list_cell_write(file, worksheet, participant, i, gradebook);
        fputc(',', file);
    }
    // Where an entry may be the participant's, nobody can say that there is none.
    if (row == NULL) {
        const char *why = participant->is_nobody   ? ""
                          : participant->is_fitted ? "not entered"
                                                   : "no submission";
        no_row_write(file, gradebook, participant, why);
    } else {
        const char *why = row->time_unknown;
        row_write(file, gradebook, row, why != NULL ? why : "");
    }
}

// Does another grade than ours stand there already?
static int has_other_grade(const Worksheet *worksheet, const Participant *participant,
                           const Gradebook *gradebook)
{
    char grade[32], decimal;
    double ours, theirs;
    const char *cell = participant->cells[worksheet->grade_column];
    if (participant->row == NULL || !row_is_entered(gradebook, participant->row) || *cell == '\0' ||
        strcmp(cell, "-") == 0) {
        return 0;
    }
    worksheet_grade(worksheet, participant, gradebook->max_score, grade);
    if (sheet_number_read(cell, &theirs, &decimal) != 0) {
        // Blackboard has words for an attempt that is not graded: "Needs Grading".
        return worksheet->system != LIST_BLACKBOARD;
    }
    return sheet_number_read(grade, &ours, &decimal) != 0 || ours != theirs;
}

// What becomes of the column of grades, where it is not simply filled.
static void grades_tell(const Worksheet *worksheet, const Gradebook *gradebook)
{
    if (worksheet->grade_column < 0) {
        complain("gradebook: %s: found no column \"Grade\" or \"Bewertung\" to fill, nor "
                 "was another named (COLUMN=): points are in the columns behind only",
                 worksheet->path);
        return;
    }
    for (int i = 1; i < worksheet->n_participants; i++) {
        const Participant *participant = &worksheet->participants[i];
        if (has_other_grade(worksheet, participant, gradebook)) {
            const char *cell = participant->cells[worksheet->grade_column];
            complain("gradebook: %s: line %d has the grade \"%s\" already: %s", worksheet->path,
                     i + 1, cell,
                     list_cell_is_excused(worksheet, cell) ? "it stays" : "gradebook.csv has ours");
        }
    }
}

// Rows that are not entered, or not for everybody.
static void left_over_write(FILE *file, const Worksheet *worksheet, const Gradebook *gradebook)
{
    for (int i = 0; i < gradebook->n_rows; i++) {
        const Entered *entered = &worksheet->entered[i];
        const Row *row = &gradebook->rows[i];
        if (entered->n_participants > 0 && entered->why_not == NULL) {
            continue;
        }
        const char *why = tally_why_undecided(gradebook, worksheet, row);
        empty_write(file, worksheet->n_columns);
        row_write(file, gradebook, row,
                  why != NULL                 ? why
                  : entered->left_out != NULL ? entered->left_out
                                              : "");
    }
}

// The list with its grades filled in; then what could not be entered, and earlier attempts.
static void worksheet_write(FILE *file, const Gradebook *gradebook, const Worksheet *worksheet)
{
    for (int i = 0; i < worksheet->n_columns; i++) {
        csv_cell_copy(file, worksheet->participants[0].cells[i]);
        fputc(',', file);
    }
    titles_write(file, gradebook, "not entered");
    for (int i = 1; i < worksheet->n_participants; i++) {
        participant_write(file, worksheet, &worksheet->participants[i], gradebook);
    }
    grades_tell(worksheet, gradebook);
    left_over_write(file, worksheet, gradebook);
}

int gradebook_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet)
{
    OutputFile output;
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    if (worksheet != NULL) {
        worksheet_write(output.file, gradebook, worksheet);
        return output_file_commit(&output);
    }
    titles_write(output.file, gradebook, NULL);
    for (int i = 0; i < gradebook->n_rows; i++) {
        row_write(output.file, gradebook, &gradebook->rows[i], NULL);
    }
    return output_file_commit(&output);
}
