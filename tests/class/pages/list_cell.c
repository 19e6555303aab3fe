// What stands in a list's cells, and what a row says in a line (see list_cell.h).
#include "list_cell.h"

#include "corrections.h"
#include "csv_cell.h"
#include "lateness.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

char *row_comment(const Gradebook *gradebook, const Row *row)
{
    char *comment = NULL;
    size_t length;
    FILE *text = row->status != ROW_NOT_GRADED ? open_memstream(&comment, &length) : NULL;
    if (text == NULL) {
        return NULL;
    }
    if (row->status == ROW_NOTHING) {
        fprintf(text, COMMENT_NOTHING ": %s", row->reason);
        fclose(text);
        return comment;
    }
    fprintf(text, "%d of %d points:", row->score, gradebook->max_score);
    for (int i = 0; i < gradebook->n_tasks; i++) {
        const Column *task = &gradebook->tasks[i];
        fprintf(text, "%s %s %d/%d", i > 0 ? "," : "", task->id, row->points[i], task->max_points);
    }
    if (row->fault != NULL) {
        fprintf(text, ". First fault: %s%s%s", row->fault, row->is_fault_hidden ? "" : ": ",
                row->is_fault_hidden ? "" : row->fault_message);
    }
    if (corrections_has(gradebook, row)) {
        fputs(". Corrected by hand: ", text);
        corrections_write(text, gradebook, row, NULL);
    }
    if (lateness_is_late(lateness_of(gradebook, row))) {
        fputs(". Late: ", text);
        lateness_write(text, gradebook, row);
    }
    fclose(text);
    return comment;
}

// Moodle's in English and in German, and Blackboard's. Somebody's own comment stays.
static const char *const comment_titles[] = {"Feedback comments", "Feedback als Kommentar",
                                             "Feedback to Learner", NULL};

int list_cell_is_excused(const Worksheet *worksheet, const char *cell)
{
    return worksheet->system == LIST_CANVAS &&
           (strcasecmp(cell, "EX") == 0 || strcasecmp(cell, "N/A") == 0);
}

// A comment that row_comment() has made, perhaps for an earlier run: it is replaced.
static int is_our_comment(const char *cell)
{
    int points, most, n = 0;
    sscanf(cell, "%d of %d points:%n", &points, &most, &n);
    return n > 0 || strncmp(cell, COMMENT_NOTHING, strlen(COMMENT_NOTHING)) == 0;
}

// What a comment for a participant says: about what was handed in, or what the instructor wrote for
// one who handed in nothing. Owned; NULL: nothing.
static char *comment_make(const Gradebook *gradebook, const Participant *participant)
{
    char *comment = NULL;
    size_t length;
    if (participant->row != NULL && participant->row->time_unknown != NULL) {
        return NULL;
    }
    if (participant->row != NULL) {
        return row_comment(gradebook, participant->row);
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
