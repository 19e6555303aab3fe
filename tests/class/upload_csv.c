// Filling a list of participants (see upload_csv.h).
//
// Lines and columns keep their order, and cells their text, but what a spreadsheet would take for a
// formula. Canvas knows a student again by the ID,
// Moodle by the identifier, Blackboard and Brightspace by the user name.
#include "upload_csv.h"

#include "csv_cell.h"
#include "feedback.h"
#include "output_file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

// Moodle's in English and in German, and Blackboard's. Somebody's own comment stays.
static const char *const comment_titles[] = {"Feedback comments", "Feedback als Kommentar",
                                             "Feedback to Learner", NULL};

int list_cell_is_excused(const Worksheet *worksheet, const char *cell)
{
    return worksheet->system == LIST_CANVAS &&
           (strcasecmp(cell, "EX") == 0 || strcasecmp(cell, "N/A") == 0);
}

void list_cell_write(FILE *file, const Worksheet *worksheet, const Participant *participant,
                     int column, const Gradebook *gradebook)
{
    const Row *row = participant->row;
    const char *cell = participant->cells[column];
    char grade[32], *comment = NULL;
    if (column == worksheet->grade_column && row != NULL && row_is_entered(gradebook, row) &&
        !list_cell_is_excused(worksheet, cell)) {
        worksheet_grade(worksheet, participant, gradebook->max_score, grade);
        cell = grade;
    } else if (row != NULL && cell[0] == '\0' &&
               worksheet_has_title(worksheet, column, comment_titles)) {
        comment = feedback_comment(gradebook, row);
        cell = comment != NULL ? comment : cell;
    }
    csv_cell_copy(file, cell);
    free(comment);
}

int upload_csv(const Gradebook *gradebook, const char *path, const Worksheet *worksheet)
{
    OutputFile output;
    if (worksheet->grade_column < 0) {
        return 0;
    }
    if (output_file_open(&output, path) != 0) {
        return -1;
    }
    for (int i = 0; i < worksheet->n_participants; i++) {
        const char *mark = "";
        for (int column = 0; column < worksheet->n_columns; column++) {
            if (worksheet->is_uploaded[column]) {
                fputs(mark, output.file);
                list_cell_write(output.file, worksheet, &worksheet->participants[i], column,
                                gradebook);
                mark = ",";
            }
        }
        fputc('\n', output.file);
    }
    return output_file_commit(&output);
}
