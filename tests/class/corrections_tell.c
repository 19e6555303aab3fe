// Telling of corrections: in a line, as a page's rows (see corrections.h).
#include "corrections.h"

#include "class_page.h"
#include "html.h"
#include "participant_fit.h"

#include <stdlib.h>
#include <string.h>

int corrections_has(const Gradebook *gradebook, const Row *row)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        if (corrections->all[i].row == row) {
            return 1;
        }
    }
    return 0;
}

int corrections_count_waiting(const Gradebook *gradebook)
{
    const Corrections *corrections = gradebook->corrections;
    int n = 0;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        n += corrections->all[i].has_points && !corrections->all[i].is_applied;
    }
    return n;
}

// What a correction changes, "gradient: 40 to 45 (+5)"; nothing where it names no task.
static void change_write(FILE *file, const Correction *correction)
{
    if (correction->task == NULL) {
        return;
    }
    fputs(correction->check != NULL ? correction->check : correction->task, file);
    if (correction->is_applied) {
        fprintf(file, ": %d to %d (%+d)", correction->before, correction->after,
                correction->after - correction->before);
    } else if (correction->has_points) {
        fprintf(file, ": %s%d not applied, as nothing was graded",
                correction->is_relative && correction->points >= 0 ? "+" : "", correction->points);
    }
}

static int is_of(const Correction *correction, const Row *row, const Participant *participant)
{
    return row != NULL ? correction->row == row
                       : participant != NULL && correction->participant == participant;
}

void corrections_write(FILE *file, const Gradebook *gradebook, const Row *row,
                       const Participant *participant)
{
    const Corrections *corrections = gradebook->corrections;
    const char *between = "";
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        if (!is_of(correction, row, participant)) {
            continue;
        }
        fputs(between, file);
        change_write(file, correction);
        fprintf(file, "%s%s",
                correction->task != NULL && correction->comment[0] != '\0' ? ": " : "",
                correction->comment);
        if (correction->task == NULL && correction->comment[0] == '\0') {
            fprintf(file, "more time until %s", correction->until);
        }
        between = "; ";
    }
}

// Change, comment, until.
static void cells_write(FILE *page, const Correction *correction)
{
    char *change = NULL;
    size_t length;
    FILE *stream = open_memstream(&change, &length);
    if (stream != NULL) {
        change_write(stream, correction);
        fclose(stream);
    }
    // Task and numbers are ours, the rest is the instructor's.
    fprintf(page, "<td>%s</td><td>", change != NULL ? change : "");
    html_message(page, correction->comment);
    fputs("</td><td>", page);
    html_line(page, correction->until);
    fputs("</td></tr>\n", page);
    free(change);
}

void corrections_rows_write(FILE *page, const Gradebook *gradebook, const Row *row)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        if (corrections->all[i].row == row) {
            fputs("<tr>", page);
            cells_write(page, &corrections->all[i]);
        }
    }
}

void corrections_class_write(FILE *page, const Gradebook *gradebook)
{
    const Corrections *corrections = gradebook->corrections;
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        fputs("<tr><td class=\"name\">", page);
        if (correction->row != NULL) {
            class_name_write(page, correction->row);
        } else {
            char name[ENTRY_NAME_BYTES];
            participant_name(corrections->worksheet, correction->participant, name);
            html_line(page, name);
        }
        fputs("</td>", page);
        cells_write(page, correction);
    }
}

const char *corrections_until(const Gradebook *gradebook, const Row *row,
                              const Participant *participant)
{
    const Corrections *corrections = gradebook->corrections;
    const char *last = "";
    for (int i = 0; corrections != NULL && i < corrections->n; i++) {
        const Correction *correction = &corrections->all[i];
        if (is_of(correction, row, participant) && strcmp(correction->until, last) > 0) {
            last = correction->until;
        }
    }
    return last;
}
