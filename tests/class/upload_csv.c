// Filling a list of participants (see upload_csv.h).
//
// Lines and columns keep their order, and cells their text, but what a spreadsheet would take for a
// formula. Canvas knows a student again by the ID,
// Moodle by the identifier, Blackboard and Brightspace by the user name.
#include "upload_csv.h"

#include "corrections.h"
#include "csv_cell.h"
#include "feedback.h"
#include "lateness.h"
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

// A comment that feedback_comment() has made, perhaps for an earlier run: it is replaced.
static int is_our_comment(const char *cell)
{
    int points, most, n = 0;
    sscanf(cell, "%d of %d points:%n", &points, &most, &n);
    return n > 0 || strncmp(cell, FEEDBACK_NOTHING, strlen(FEEDBACK_NOTHING)) == 0;
}

// What a comment for a participant says: about what was handed in, or what the instructor wrote for
// one who handed in nothing. Owned; NULL: nothing.
static char *comment_make(const Gradebook *gradebook, const Participant *participant)
{
    char *comment = NULL;
    size_t length;
    if (participant->row != NULL && lateness_unknown(gradebook, participant->row) != NULL) {
        return NULL;
    }
    if (participant->row != NULL) {
        return feedback_comment(gradebook, participant->row);
    }
    FILE *text = open_memstream(&comment, &length);
    if (text != NULL) {
        corrections_write(text, gradebook, NULL, participant);
        fclose(text);
    }
    return comment;
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
    } else if ((cell[0] == '\0' || is_our_comment(cell)) &&
               worksheet_has_title(worksheet, column, comment_titles)) {
        comment = comment_make(gradebook, participant);
        cell = comment != NULL ? comment : cell;
    }
    csv_cell_copy(file, cell);
    free(comment);
}

// A list of somebody's own comes back in the form in which it came; a system takes plain CSV.
static SheetForm form_of(const Worksheet *worksheet)
{
    return worksheet->system == LIST_OTHER ? worksheet->form : (SheetForm){.delimiter = ','};
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
    const SheetForm form = form_of(worksheet);
    const char *line_end = form.has_dos_lines ? "\r\n" : "\n";
    const char delimiter[] = {form.delimiter, '\0'};
    fputs(form.has_mark ? "\xEF\xBB\xBF" : "", output.file);
    if (form.has_sep) {
        fprintf(output.file, "sep=%s%s", delimiter, line_end);
    }
    for (int i = 0; i < worksheet->n_participants; i++) {
        const char *mark = "";
        for (int column = 0; column < worksheet->n_columns; column++) {
            if (worksheet->is_uploaded[column]) {
                fputs(mark, output.file);
                list_cell_write(output.file, worksheet, &worksheet->participants[i], column,
                                gradebook);
                mark = delimiter;
            }
        }
        fputs(line_end, output.file);
    }
    return output_file_commit(&output);
}
